#include "core/io/image_file.h"
#include "core/io/jpeg_scans.h"
#include "tests/core/io/file_limit.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/io/write_as.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>
#include <atomic>
#include <chrono>
#include <fstream>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <thread>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void put(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Every format and depth that is written, with an image that it holds.
struct Kind {
    const char* name;
    Depth depth;
    const char* label;

    friend void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.label; }
};
constexpr std::array<Kind, 9> kKinds = {{{"a.png", Depth::Bits8, "png8"},
                                         {"a.png", Depth::Bits16, "png16"},
                                         {"a.jpg", Depth::Bits8, "jpeg"},
                                         {"a.tif", Depth::Bits8, "tiff8"},
                                         {"a.tif", Depth::Bits16, "tiff16"},
                                         {"a.tif", Depth::Float, "tiffFloat"},
                                         {"a.exr", Depth::Half, "exrHalf"},
                                         {"a.exr", Depth::Float, "exrFloat"},
                                         {"a.hdr", Depth::Float, "hdr"}}};

} // namespace

class Kinds : public ::testing::TestWithParam<Kind> {
protected:
    fs::path path() const { return m_folder / GetParam().name; }
    void write() const { writeImage(path(), m_image, as(GetParam().depth)); }
    /// Bytes of the whole file.
    std::uintmax_t wholeSize() const {
        write();
        const std::uintmax_t size = fs::file_size(path());
        fs::remove(path());
        return size;
    }

    TemporaryFolder m_folder;
    Image m_image = noise({200, 150}, 3);
};

INSTANTIATE_TEST_SUITE_P(ImageFile, Kinds, ::testing::ValuesIn(kKinds),
                         [](const auto& test) { return test.param.label; });

TEST_P(Kinds, AFullDiskLeavesNoFile) {
    const std::uintmax_t size = wholeSize();
    for (const std::uintmax_t bytes : {std::uintmax_t{0}, std::uintmax_t{10}, size / 4, size / 2, size - 1}) {
        const FileLimit limit(bytes);
        EXPECT_THAT([&] { write(); }, refusal(GetParam().name, "cannot be written"))
            << bytes << " of " << size;
        EXPECT_EQ(m_folder.entries(), 0) << bytes << " of " << size;
        fs::remove(path());
    }
}

TEST_P(Kinds, AFullDiskKeepsTheEarlierFile) {
    const std::uintmax_t size = wholeSize();
    put(path(), "what was there before");
    for (const std::uintmax_t bytes : {std::uintmax_t{100}, size - 1}) {
        const FileLimit limit(bytes);
        EXPECT_THROW(write(), Error) << bytes;
        EXPECT_EQ(get(path()), "what was there before") << bytes;
        EXPECT_EQ(m_folder.entries(), 1) << bytes;
    }
}

TEST_P(Kinds, StoppingLeavesNoFile) {
    int rows = 0;
    const WriteOptions options{
        .depth = GetParam().depth, .space = "srgb", .recipe = {}, .attributes = {}, .check = [&] {
            if (++rows == 70)
                throw std::length_error("stop");
        }};
    EXPECT_THROW(writeImage(path(), m_image, options), std::length_error);
    EXPECT_EQ(m_folder.entries(), 0);
}

TEST_P(Kinds, CutShortIsRefused) {
    write();
    const std::string whole = get(path());
    for (const std::size_t length : {whole.size() / 2, whole.size() * 9 / 10}) {
        put(path(), std::string_view(whole).substr(0, length));
        EXPECT_THAT([&] { readImage(path()); }, refusal(GetParam().name)) << length << " of " << whole.size();
    }
}

TEST_P(Kinds, CutToItsFirstBytesIsRefused) {
    write();
    const std::string whole = get(path());
    for (const std::size_t length : {4U, 16U, 40U}) {
        put(path(), std::string_view(whole).substr(0, length));
        EXPECT_THAT([&] { readImage(path()); }, refusal(GetParam().name)) << length;
        EXPECT_THAT([&] { readImageInfo(path()); }, refusal(GetParam().name)) << length;
    }
}

TEST_P(Kinds, TooManyPixelsAreRefusedWithTheFigure) {
    write();
    EXPECT_THAT([&] { readImage(path(), {.largestPixels = 29999}); }, refusal("200 × 150 px", "29,999"));
    EXPECT_NO_THROW(readImage(path(), {.largestPixels = 30000}));
}

TEST_P(Kinds, AnUnwritableFolderIsNamed) {
    put(m_folder / "file", "a file, not a folder");
    const fs::path inFile = m_folder / "file" / GetParam().name;
    EXPECT_THAT([&] { writeImage(inFile, m_image, as(GetParam().depth)); },
                refusal("cannot be written", (m_folder / "file").string()));
    EXPECT_THAT([&] { checkWritable(inFile, 3, Depth::Bits8); }, refusal("cannot be written"));
    EXPECT_EQ(m_folder.entries(), 1);
}

TEST(ReadImage, NamesAFileThatIsNotThere) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { readImage(folder / "gone.png"); }, refusal("gone.png", "no file"));
}

TEST(ReadImage, RefusesAFolder) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { readImage(folder.path()); }, refusal("is a folder"));
}

TEST(ReadImage, RefusesAFileWithoutBytes) {
    const TemporaryFolder folder;
    put(folder / "a.png", "");
    EXPECT_THAT([&] { readImage(folder / "a.png"); }, refusal("a.png", "0 bytes"));
}

TEST(ReadImage, RefusesTextNamedAsAnImage) {
    const TemporaryFolder folder;
    put(folder / "a.png", "Dear Sir or Madam,\n");
    EXPECT_THAT([&] { readImage(folder / "a.png"); }, refusal("a.png", "not an image"));
}

TEST(ReadImage, DoesNotWaitForAPipe) {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "a.png";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    // Ends the wait, should there be one.
    std::atomic<bool> rescued = false;
    {
        const std::jthread rescue([&](const std::stop_token& stop) {
            const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
            while (!stop.stop_requested() && std::chrono::steady_clock::now() < end)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            rescued = !stop.stop_requested();
            if (rescued)
                std::ofstream(pipe) << "x";
        });
        EXPECT_THAT([&] { readImage(pipe); }, refusal("a.png"));
    }
    EXPECT_FALSE(rescued);
}

TEST(ReadImage, CountsValuesThatAreNotFiniteAndShowsTheFirst) {
    const TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.tif"}) {
        Image image = noise({40, 30}, 3);
        image(17, 5, 1) = std::numeric_limits<float>::quiet_NaN();
        image(3, 6, 0) = std::numeric_limits<float>::infinity();
        image(39, 29, 2) = -std::numeric_limits<float>::infinity();
        writeImage(folder / name, image, as(Depth::Float, "linear"));
        EXPECT_THAT([&] { readImage(folder / name); }, refusal(name, "3 values", "(17, 5)")) << name;
    }
}

TEST(ReadImage, RefusesAHugeHeaderBeforeItTakesMemory) {
    const TemporaryFolder folder;
    writeHugePngHeader(folder / "a.png", 60000, 60000);
    EXPECT_THAT([&] { readImage(folder / "a.png"); }, refusal("60000 × 60000", "536,870,912"));
}

TEST(ReadImage, RefusesAHeaderBeyondWhatAFormatAllows) {
    const TemporaryFolder folder;
    for (const std::uint32_t side : {0U, 0x7fffffffU, 0xffffffffU}) {
        writeHugePngHeader(folder / "a.png", side, side);
        EXPECT_THAT([&] { readImage(folder / "a.png"); }, refusal("a.png")) << side;
    }
}

TEST(ReadImage, RefusesEntriesOfHeadersThatAreLongerThanTheFile) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.exr"}) {
        WriteOptions options;
        options.depth = std::string_view(name) == "a.exr" ? Depth::Float : Depth::Bits8;
        options.recipe = "{}";
        writeImage(folder / name, blobs({20, 10}, 3), options);
        std::string bytes = readText(folder / name);
        // The length of the recipe: of a PNG's chunk before the word tEXt, of an EXR's attribute after
        // "string".
        const bool png = bytes.starts_with("\x89PNG");
        const std::size_t place =
            png ? bytes.find("tEXt") - 4 : bytes.find(std::string("texloom:recipe\0string\0", 22)) + 22;
        ASSERT_LT(place, bytes.size());
        bytes.replace(place, 4, "\x70\x00\x00\x70", 4);
        writeText(folder / name, bytes);
        EXPECT_THAT([&] { readImage(folder / name); }, refusal(name, "damaged", "bytes"));
    }
}

TEST(ReadImage, OpensAJpegThatLacksNothingButItsEnd) {
    const TemporaryFolder folder;
    writeImage(folder / "a.jpg", noise({101, 77}, 3), {});
    const Image whole = readImage(folder / "a.jpg").image;
    const std::string bytes = get(folder / "a.jpg");
    ASSERT_TRUE(bytes.ends_with("\xff\xd9"));
    for (const std::size_t left : {1U, 2U}) {
        put(folder / "a.jpg", std::string_view(bytes).substr(0, bytes.size() - left));
        const LoadedImage loaded = readImage(folder / "a.jpg");
        EXPECT_TRUE(samePixels(loaded.image, whole));
        // A decoder that has all rows without looking for the marker has nothing to say.
        ASSERT_LE(loaded.info.notes.size(), 1U);
        for (const Message& note : loaded.info.notes)
            EXPECT_THAT(note.text(), HasSubstr("a.jpg breaks off before its end marker"));
    }
    for (const std::size_t left : {4U, 40U, 400U}) { // of the last row
        put(folder / "a.jpg", std::string_view(bytes).substr(0, bytes.size() - left));
        EXPECT_THAT([&] { readImage(folder / "a.jpg"); }, refusal("a.jpg", "premature end")) << left;
    }
}

/// A decoder takes the scans that are there for the whole picture.
TEST(ReadImage, RefusesAJpegThatBreaksOffBetweenScans) {
    const TemporaryFolder folder;
    writeForeign(folder / "a.jpg", noise({101, 77}, 3), {.progressive = true});
    const Image whole = readImage(folder / "a.jpg").image;
    const std::string bytes = get(folder / "a.jpg");
    std::vector<std::size_t> tables; // of which each scan has its own before it
    for (std::size_t at = bytes.find("\xff\xda"); at != std::string::npos;
         at = bytes.find("\xff\xda", at + 2))
        tables.push_back(bytes.rfind("\xff\xc4", at));
    ASSERT_GE(tables.size(), 3U);
    for (std::size_t i = 1; i < tables.size(); ++i) {
        put(folder / "a.jpg", std::string_view(bytes).substr(0, tables[i]));
        EXPECT_THAT([&] { readImage(folder / "a.jpg"); }, refusal("a.jpg", "breaks off", "scans")) << i;
    }
    put(folder / "a.jpg", std::string_view(bytes).substr(0, bytes.size() - 2));
    EXPECT_TRUE(samePixels(readImage(folder / "a.jpg").image, whole));
}

/// Components may have a scan each in a file that is not progressive, too.
TEST(HasAllScans, WantsEveryComponentAndCoefficient) {
    const auto frame = [](char kind) {
        return std::string("\xff\xd8\xff", 3) + kind +
               std::string("\0\x0e\x08\0\x08\0\x08\x02\1\x11\0\2\x11\0", 14);
    };
    const auto scan = [](char component, char first, char last, char bits) {
        return std::string("\xff\xda\0\x08\x01", 5) + component + std::string(1, '\0') + first + last + bits +
               std::string("\x12\xff\0\xff\xd0\x34", 6);
    };
    const std::string plain = frame('\xc0') + scan(1, 0, 63, 0), progressive = frame('\xc2');
    EXPECT_FALSE(hasAllScans(frame('\xc0')));
    EXPECT_FALSE(hasAllScans(plain));
    EXPECT_TRUE(hasAllScans(plain + scan(2, 0, 63, 0)));
    EXPECT_FALSE(hasAllScans(plain + "\xff\xd9" + scan(2, 0, 63, 0)));
    const std::string first = progressive + scan(1, 0, 63, 0) + scan(2, 0, 0, 0);
    EXPECT_FALSE(hasAllScans(first));
    EXPECT_FALSE(hasAllScans(first + scan(2, 1, 62, 0)));
    EXPECT_FALSE(hasAllScans(first + scan(2, 1, 63, 1)));
    EXPECT_TRUE(hasAllScans(first + scan(2, 1, 63, 1) + scan(2, 1, 63, 0x10)));
    for (std::size_t length = 0; length < first.size(); ++length)
        EXPECT_FALSE(hasAllScans(std::string_view(first).substr(0, length))) << length;
}

TEST(ReadImage, RefusesAPngWithFarTooFewRows) {
    const TemporaryFolder folder;
    writeHugePngHeader(folder / "a.png", 1000, 1000);
    EXPECT_THAT([&] { readImage(folder / "a.png"); }, refusal("a.png"));
}

TEST(WriteImage, NamesAnUnknownExtensionAndTheKnownOnes) {
    const TemporaryFolder folder;
    EXPECT_THAT(
        [&] {
            writeImage(folder / "a.xyz", noise({4, 4}, 3), {});
        },
        ThrowsMessage<UsageError>(AllOf(HasSubstr(".xyz"), HasSubstr(".png"), HasSubstr(".exr"))));
    EXPECT_THROW(checkWritable(folder / "a", 3, Depth::Bits8), UsageError);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteImage, NamesChannelsThatAFormatDoesNotHold) {
    const TemporaryFolder folder;
    for (const auto& [name, channels] : {std::pair{"a.png", 5}, {"a.jpg", 4}, {"a.jpg", 2}, {"a.hdr", 1}}) {
        EXPECT_THAT([&] { checkWritable(folder / name, channels, Depth::Bits8); },
                    refusal(std::to_string(channels) + " channels"));
        EXPECT_THROW(writeImage(folder / name, noise({4, 4}, channels), as(depthsFor(name).front())),
                     UsageError);
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteImage, NamesADepthThatAFormatDoesNotHold) {
    const TemporaryFolder folder;
    EXPECT_THAT(
        [&] {
            writeImage(folder / "a.png", noise({4, 4}, 3), as(Depth::Half));
        },
        refusal(".png", "half"));
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteImage, TakesExtensionsInCapitals) {
    const TemporaryFolder folder;
    writeImage(folder / "A.PNG", noise({4, 4}, 3), {});
    EXPECT_EQ(readImageInfo(folder / "A.PNG").format, "png");
}

TEST(WriteImage, ClampsWhatIntegersDoNotHold) {
    const TemporaryFolder folder;
    Image image({2, 1}, 1);
    image(0, 0, 0) = -3;
    image(1, 0, 0) = 7;
    writeImage(folder / "a.png", image, {});
    const Image back = readImage(folder / "a.png").image;
    EXPECT_EQ(back(0, 0, 0), 0);
    EXPECT_EQ(back(1, 0, 0), 1);
}

TEST(CheckWritable, RefusesAFolder) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a.png");
    EXPECT_THAT([&] { checkWritable(folder / "a.png", 3, Depth::Bits8); }, refusal("it is a folder"));
}

TEST(CheckWritable, NamesAMissingFolder) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { checkWritable(folder / "gone" / "a.png", 3, Depth::Bits8); },
                refusal("no folder", (folder / "gone").string()));
}

TEST(CheckWritable, LeavesNothing) {
    const TemporaryFolder folder;
    checkWritable(folder / "a.png", 3, Depth::Bits8);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteText, AFullDiskKeepsTheEarlierFile) {
    const TemporaryFolder folder;
    writeText(folder / "a.json", "before");
    const FileLimit limit(1000);
    EXPECT_THAT([&] { writeText(folder / "a.json", std::string(100000, 'x')); },
                refusal("cannot be written"));
    EXPECT_EQ(get(folder / "a.json"), "before");
    EXPECT_EQ(folder.entries(), 1);
}

} // namespace texloom::test
