#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/channel_names.h"
#include "core/io/image_file.h"
#include "core/io/temporary_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <optional>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// Longer texts come back from a TIFF cut off.
constexpr std::size_t kLongestTiffText = 65535;

struct Format {
    std::string_view name;
    std::vector<std::string_view> extensions;
    std::vector<Depth> depths;
    std::vector<int> channels; ///< counts it can hold; empty for any
};

const std::vector<Format>& formats() {
    static const std::vector<Format> all = {
        {"png", {".png"}, {Depth::Bits8, Depth::Bits16}, {1, 2, 3, 4}},
        {"tiff", {".tif", ".tiff"}, {Depth::Bits16, Depth::Bits8, Depth::Float}, {}},
        {"openexr", {".exr"}, {Depth::Half, Depth::Float}, {}},
        {"jpeg", {".jpg", ".jpeg"}, {Depth::Bits8}, {1, 3}},
        {"hdr", {".hdr"}, {Depth::Float}, {3}},
    };
    return all;
}

const Format& formatFor(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Format& format : formats())
        if (std::find(format.extensions.begin(), format.extensions.end(), extension) !=
            format.extensions.end())
            return format;
    if (extension.empty())
        failUsage(
            "{} cannot be written: the name ends in nothing that names a format; Texloom writes .png, .jpg, "
            ".tif, .exr and .hdr.",
            path.string());
    failUsage("{} cannot be written: the name ends in {}; Texloom writes .png, .jpg, .tif, .exr and .hdr.",
              path.string(), extension);
}

OIIO::TypeDesc typeOf(Depth depth) {
    switch (depth) {
    case Depth::Bits8:
        return OIIO::TypeDesc::UINT8;
    case Depth::Bits16:
        return OIIO::TypeDesc::UINT16;
    case Depth::Half:
        return OIIO::TypeDesc::HALF;
    case Depth::Float:
        break;
    }
    return OIIO::TypeDesc::FLOAT;
}

void checkFormat(const fs::path& path, const Format& format, int channels, Depth depth) {
    if (!format.channels.empty() &&
        std::find(format.channels.begin(), format.channels.end(), channels) == format.channels.end()) {
        std::vector<std::string> counts;
        for (const int count : format.channels)
            counts.push_back(std::to_string(count));
        failUsage("{} cannot be written: the image has {} channels, and {} holds {}.", path.string(),
                  channels, path.extension().string(), listOf(counts));
    }
    if (std::find(format.depths.begin(), format.depths.end(), depth) == format.depths.end())
        failUsage("{} cannot be written: {} does not hold {} samples.", path.string(),
                  path.extension().string(), depthName(depth));
}

std::atomic<bool> datesLeftOut = false;

/// The date of files, where it is not the time of day; see reproducible-builds.org/specs/source-date-epoch.
std::optional<std::time_t> fixedDate() {
    std::uint64_t seconds = 0;
    if (const char* const epoch = std::getenv("SOURCE_DATE_EPOCH"); epoch && parseUnsigned(epoch, seconds))
        return static_cast<std::time_t>(seconds);
    return datesLeftOut ? std::optional<std::time_t>(0) : std::nullopt;
}

/// As EXIF and TIFF write it, in UTC.
std::string dateText(std::time_t date) {
    std::tm parts{};
    ::gmtime_r(&date, &parts);
    return fmt::format("{:04}:{:02}:{:02} {:02}:{:02}:{:02}", parts.tm_year + 1900, parts.tm_mon + 1,
                       parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

std::vector<std::string> channelNames(int channels, const WriteOptions& options) {
    if (options.channelNames.size() == static_cast<std::size_t>(channels))
        return options.channelNames;
    if (options.space == "raw" && channels == 2)
        return {"R", "G"}; // two values, not one with alpha
    return defaultChannelNames(channels);
}

/// Multiplies colours by alpha, as all that read an EXR expect.
void multiplyByAlpha(std::vector<float>& row, int channels, const std::vector<AlphaGroup>& groups) {
    for (std::size_t first = 0; first < row.size(); first += static_cast<std::size_t>(channels))
        for (const AlphaGroup& group : groups)
            for (const int c : group.colours)
                row[first + static_cast<std::size_t>(c)] *=
                    row[first + static_cast<std::size_t>(group.alpha)];
}

OIIO::ImageSpec specFor(Size size, int channels, const Format& format, const WriteOptions& options) {
    OIIO::ImageSpec spec(size.width, size.height, channels, typeOf(options.depth));
    // In a TIFF it would become an EXIF directory, which this OpenImageIO writes broken through a stream;
    // readers take integers for sRGB there without being told.
    if (format.name != "tiff")
        spec.attribute("oiio:ColorSpace", options.space == "srgb" ? "sRGB" : "Linear");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.channelnames = channelNames(channels, options);
    const std::vector<AlphaGroup> alphas = alphaGroups(spec.channelnames);
    spec.alpha_channel = alphas.empty() ? -1 : alphas.front().alpha;
    spec.attribute("texloom:space", options.space);
    spec.attribute("Software", "Texloom");
    if (const std::optional<std::time_t> date = fixedDate())
        spec.attribute("DateTime", dateText(*date));
    if (format.name == "jpeg") {
        spec.attribute("Compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    if (format.name == "openexr")
        spec.attribute("compression", "zip");
    if (format.name == "tiff")
        spec.attribute("compression", options.compressed ? "zip" : "none");
    const bool fits = format.name != "tiff" || options.recipe.size() < kLongestTiffText;
    if (!options.recipe.empty() && fits)
        spec.attribute(format.name == "tiff" ? "ImageDescription" : "texloom:recipe", options.recipe);
    for (const auto& [name, text] : options.attributes)
        spec.attribute(name, text);
    return spec;
}

/// Lets an encoder write to, and read back from, a temporary file.
class TemporaryStream : public OIIO::Filesystem::IOProxy {
public:
    explicit TemporaryStream(TemporaryFile& file) : IOProxy("", Write), m_file(file) {}

    const char* proxytype() const override { return "temporary"; }
    std::size_t read(void* data, std::size_t size) override {
        const std::size_t count = m_file.read(data, size, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t write(const void* data, std::size_t size) override {
        const std::size_t count = m_file.write(data, size, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t pread(void* data, std::size_t size, std::int64_t offset) override {
        return m_file.read(data, size, offset);
    }
    std::size_t pwrite(const void* data, std::size_t size, std::int64_t offset) override {
        return m_file.write(data, size, offset);
    }
    std::size_t size() const override { return m_file.size(); }

private:
    TemporaryFile& m_file;
};

/// A Radiance file has no place for attributes, but its header for remarks: by this one it is known again.
void addRemark(TemporaryFile& file) {
    constexpr std::string_view kRemark = "# Texloom\n";
    constexpr std::size_t kBehind = std::string_view("#?RADIANCE\n").size();
    std::vector<char> block(1 << 20);
    for (std::size_t end = file.size(); end > kBehind;) {
        const std::size_t count = std::min(block.size(), end - kBehind);
        end -= count;
        file.read(block.data(), count, static_cast<std::int64_t>(end));
        file.write(block.data(), count, static_cast<std::int64_t>(end + kRemark.size()));
    }
    file.write(kRemark.data(), kRemark.size(), static_cast<std::int64_t>(kBehind));
}

[[noreturn]] void failWriting(const fs::path& path, const std::string& message) {
    const std::string why = message.substr(0, message.find('\n'));
    fail("{} cannot be written: {}.", path.string(),
         why.empty() ? Message(TR("the disk may be full")) : Message::verbatim(why));
}

} // namespace

void writeImage(const fs::path& path, Size size, int channels, const RowSource& rows,
                const WriteOptions& options) {
    const Format& format = formatFor(path);
    checkFormat(path, format, channels, options.depth);
    TemporaryFile temporary(path);
    TemporaryStream stream(temporary);
    auto output = OIIO::ImageOutput::create(std::string(format.name));
    if (!output || !output->set_ioproxy(&stream) ||
        !output->open(path.string(), specFor(size, channels, format, options)))
        failWriting(path, output ? output->geterror() : "there is no writer for this format");
    const bool multiplied = format.name == "openexr" && options.space != "raw";
    const std::vector<AlphaGroup> alphas = alphaGroups(channelNames(channels, options));
    std::vector<float> row(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels));
    for (int y = 0; y < size.height; ++y) {
        if (options.check)
            options.check();
        rows(y, row.data());
        if (multiplied)
            multiplyByAlpha(row, channels, alphas);
        if (!output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data()))
            failWriting(path, output->geterror());
    }
    if (!output->close())
        failWriting(path, output->geterror());
    if (format.name == "hdr")
        addRemark(temporary);
    temporary.commit();
}

void writeImage(const fs::path& path, const ImageView& image, const WriteOptions& options) {
    const RowSource interleave = [&image](int y, float* row) {
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                *row++ = image(x, y, c);
    };
    writeImage(path, image.size(), image.channels, interleave, options);
}

void setReproducible(bool reproducible) {
    datesLeftOut = reproducible;
}

void checkFolder(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status))
        fail("{} cannot be written: it is a folder.", path.string());
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail("{} cannot be written: it is no ordinary file.", path.string());
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (status.type() == fs::file_type::none)
        fail("{} cannot be written: {}.", path.string(), error.message());
    if (!fs::is_directory(folder, error))
        fail("{} cannot be written: there is no folder {}.", path.string(), folder.string());
    if (::access(folder.c_str(), W_OK) != 0)
        fail("{} cannot be written: the folder {} is not writable.", path.string(), folder.string());
}

void checkWritable(const fs::path& path, int channels, Depth depth) {
    checkFormat(path, formatFor(path), channels, depth);
    checkFolder(path);
}

std::vector<Depth> depthsFor(const fs::path& path) {
    return formatFor(path).depths;
}

std::string_view depthName(Depth depth) {
    switch (depth) {
    case Depth::Bits8:
        return "8-bit";
    case Depth::Bits16:
        return "16-bit";
    case Depth::Half:
        return "half";
    case Depth::Float:
        break;
    }
    return "float";
}

} // namespace texloom
