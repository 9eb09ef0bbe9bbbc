#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/io/zip_file.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace texloom::test {

namespace fs = std::filesystem;

namespace {

std::string little(std::uint64_t number, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i, number >>= 8U)
        text += static_cast<char>(number & 0xffU);
    return text;
}

std::string deflated(const std::string& bytes) {
    std::string packed(compressBound(bytes.size()) + 64, '\0');
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

/// An archive, put together field by field as the format's description says.
class ArchiveMaker {
public:
    void add(const std::string& name, const std::string& bytes, bool deflate, unsigned flags = 0) {
        const std::string packed = deflate ? deflated(bytes) : bytes;
        const auto sum =
            crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
        const std::string common = little(20, 2) + little(flags, 2) + little(deflate ? 8 : 0, 2) +
                                   little(0, 4) + little(sum, 4) + little(packed.size(), 4) +
                                   little(bytes.size(), 4) + little(name.size(), 2) + little(0, 2);
        m_directory += little(0x02014b50, 4) + little(20, 2) + common + little(0, 2) + little(0, 2) +
                       little(0, 2) + little(0, 4) + little(m_files.size(), 4) + name;
        m_files += little(0x04034b50, 4) + common + name + packed;
        ++m_count;
    }

    std::string made(const std::string& comment = {}) const {
        return m_files + m_directory + little(0x06054b50, 4) + little(0, 4) + little(m_count, 2) +
               little(m_count, 2) + little(m_directory.size(), 4) + little(m_files.size(), 4) +
               little(comment.size(), 2) + comment;
    }

private:
    std::string m_files, m_directory;
    std::uint64_t m_count = 0;
};

bool all(const fs::path&) {
    return true;
}

} // namespace

TEST(ZipFile, UnpacksStoredAndDeflatedFilesByTheirPlainNames) {
    const TemporaryFolder folder;
    std::string large;
    for (unsigned i = 0; i < 400'000; ++i)
        large += static_cast<char>((i * i) >> 7);
    ArchiveMaker maker;
    maker.add("stone/", "", false);
    maker.add("stone/a.txt", "stored", false);
    maker.add("stone\\b.bin", large, true);
    maker.add("../../evil.txt", "inside", true);
    maker.add("other/a.txt", "second", true);
    maker.add("notes.doc", "unwanted", false);
    writeText(folder / "stone.zip", maker.made("a comment"));
    const auto wanted = [](const fs::path& name) { return name.extension() != ".doc"; };
    const std::vector<fs::path> files = unzip(folder / "stone.zip", folder / "out" / "deep", wanted);
    ASSERT_EQ(files.size(), 4U);
    const fs::path out = folder / "out" / "deep";
    EXPECT_EQ(files[0], out / "a.txt");
    EXPECT_EQ(files[2], out / "evil.txt"); // never outside
    EXPECT_EQ(files[3], out / "a_2.txt");
    EXPECT_EQ(readText(files[0]), "stored");
    EXPECT_EQ(readText(files[1]), large);
    EXPECT_EQ(readText(files[3]), "second");
}

TEST(ZipFile, RefusesWhatIsBrokenOrTooMuchInASentence) {
    const TemporaryFolder folder;
    const fs::path file = folder / "x.zip", out = folder / "out";
    ArchiveMaker maker;
    maker.add("a.txt", std::string(5000, 'a'), true);
    const std::string good = maker.made();
    writeText(file, "no archive at all, but long enough");
    EXPECT_THAT([&] { unzip(file, out, all); }, refusal("x.zip", "broken"));
    for (std::size_t at = 0; at < good.size(); ++at) { // one byte wrong, anywhere
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x5a);
        writeText(file, bad);
        try {
            for (const fs::path& made : unzip(file, out, all))
                EXPECT_EQ(readText(made), std::string(5000, 'a')) << at;
        } catch (const Error&) {}
    }
    for (std::size_t length = 0; length < good.size(); ++length) {
        writeText(file, good.substr(0, length));
        EXPECT_THROW(unzip(file, out, all), Error) << length;
    }
    writeText(file, good);
    EXPECT_THAT([&] { unzip(file, out, all, {4096, 4999}); }, refusal("x.zip", "4999"));
    EXPECT_THAT([&] { unzip(file, out, all, {0, 1U << 20U}); }, refusal("x.zip", "1 files"));
    ArchiveMaker locked;
    locked.add("a.txt", "secret", false, 1);
    writeText(file, locked.made());
    EXPECT_THAT([&] { unzip(file, out, all); }, refusal("a.txt", "packed in a way"));
}

} // namespace texloom::test
