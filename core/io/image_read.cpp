#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"

#include <OpenImageIO/imageio.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <span>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr int kMostChannels = 64;

struct Signature {
    std::string_view bytes;
    const char* format;
};

/// Only these decoders are ever given a file, whatever its name: fewer doors for hostile data.
constexpr std::array<Signature, 8> kSignatures = {{
    {"\x89PNG\r\n\x1a\n", "png"},
    {"\xff\xd8\xff", "jpeg"},
    {std::string_view("II*\0", 4), "tiff"},
    {std::string_view("MM\0*", 4), "tiff"},
    {"\x76\x2f\x31\x01", "openexr"},
    {"#?RADIANCE", "hdr"},
    {"#?RGBE", "hdr"},
    {std::string_view("II+\0", 4), "tiff"},
}};

std::string formatOf(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        fail("There is no file {}.", path.string());
    if (error)
        fail("{} cannot be read: {}.", path.string(), error.message());
    if (fs::is_directory(status))
        fail("{} is a folder, not an image.", path.string());
    if (!fs::is_regular_file(status))
        fail("{} is not an ordinary file, so it is not an image.", path.string());
    std::ifstream file(path, std::ios::binary);
    if (!file)
        fail("{} cannot be read: {}.", path.string(), std::strerror(errno));
    std::array<char, 16> start{};
    file.read(start.data(), start.size());
    const std::string_view head(start.data(), static_cast<std::size_t>(file.gcount()));
    if (head.empty())
        fail("{} is empty (0 bytes).", path.string());
    for (const Signature& signature : kSignatures)
        if (head.substr(0, signature.bytes.size()) == signature.bytes)
            return signature.format;
    fail("{} is not an image that Texloom reads (PNG, JPEG, TIFF, EXR or HDR).", path.string());
}

/// The decoder makes a table of all lines before anyone can ask for the size, so that a forged header of a
/// few bytes would take gigabytes: the data window is read here first.
void checkExrWindow(const fs::path& path) {
    constexpr std::size_t kHead = 1 << 16;
    constexpr std::int64_t kLongestSide = 1 << 17;
    constexpr std::string_view kName("dataWindow\0box2i\0\x10\0\0\0", 21);
    std::string head(kHead, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    for (std::size_t at = head.find(kName); at != std::string::npos; at = head.find(kName, at + 1)) {
        std::array<std::int32_t, 4> box{};
        if (at + kName.size() + sizeof(box) > head.size())
            return;
        std::memcpy(box.data(), head.data() + at + kName.size(), sizeof(box));
        const std::int64_t width = std::int64_t{box[2]} - box[0] + 1,
                           height = std::int64_t{box[3]} - box[1] + 1;
        if (width > kLongestSide || height > kLongestSide)
            fail("{} says it is {} × {} px; an EXR's sides can go up to {} px.", path.string(), width, height,
                 grouped(kLongestSide));
    }
}

/// Decoders take memory for as many bytes as an entry of a header says that it has, before they find out that
/// the file is shorter: sizes are held against the file's before it is decoded.
class HeaderEntries {
public:
    /// @param first offset of the first entry.
    HeaderEntries(const fs::path& path, std::streamoff first) : m_path(path), m_file(path, std::ios::binary) {
        std::error_code error;
        m_whole = fs::file_size(path, error);
        m_file.seekg(first);
    }

    /// Whether there was as much to read.
    bool read(std::span<char> bytes) {
        return static_cast<bool>(m_file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())));
    }
    /// Up to the next zero, which is read, too.
    std::string word() {
        std::string text;
        std::getline(m_file, text, '\0');
        return text;
    }
    /// Goes on behind an entry of this size and `more` bytes. @throws Error if the file cannot hold it.
    void skip(std::int64_t size, int more = 0) {
        if (size < 0 || static_cast<std::uintmax_t>(size) > m_whole)
            fail("{} is damaged: an entry of its header says that it has {} bytes, but the file has {}.",
                 m_path.string(), size, m_whole);
        m_file.seekg(size + more, std::ios::cur);
    }

private:
    const fs::path& m_path;
    std::ifstream m_file;
    std::uintmax_t m_whole = 0;
};

/// The attributes of an EXR's first header: name, type, size and value behind eight bytes of its own.
void checkExrAttributes(const fs::path& path) {
    HeaderEntries entries(path, 8);
    while (!entries.word().empty()) {
        entries.word(); // type
        std::array<char, 4> bytes{};
        if (!entries.read(bytes))
            return;
        std::int32_t size = 0;
        std::memcpy(&size, bytes.data(), sizeof(size));
        entries.skip(size);
    }
}

/// The chunks of a PNG before its pixels: size, type, value and a checksum of four bytes behind the
/// signature.
void checkPngChunks(const fs::path& path) {
    HeaderEntries entries(path, 8);
    std::array<char, 8> head{};
    while (entries.read(head) && std::string_view(head.data() + 4, 4) != "IDAT") {
        std::uint32_t size = 0;
        for (int i = 0; i < 4; ++i)
            size = size << 8U | static_cast<unsigned char>(head.at(static_cast<std::size_t>(i)));
        entries.skip(size, 4);
    }
}

/// The first line of what the library says, without a closing stop.
std::string reason(std::string message) {
    message = message.substr(0, message.find('\n'));
    while (!message.empty() && (message.back() == '.' || message.back() == ' '))
        message.pop_back();
    return message.empty() ? "the file is damaged" : message;
}

std::unique_ptr<OIIO::ImageInput> openInput(const fs::path& path, const std::string& format) {
    if (format == "openexr") {
        checkExrAttributes(path);
        checkExrWindow(path);
    }
    if (format == "png")
        checkPngChunks(path);
    auto input = OIIO::ImageInput::create(format);
    if (!input)
        fail("{} cannot be read: this build has no reader for {}.", path.string(), format);
    OIIO::ImageSpec spec, config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(path.string(), spec, config))
        fail("{} cannot be read: {}.", path.string(), reason(input->geterror()));
    return input;
}

std::string depthText(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
        return "8-bit";
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
        return "16-bit";
    case OIIO::TypeDesc::HALF:
        return "half";
    case OIIO::TypeDesc::FLOAT:
        return "float";
    default:
        return fmt::format("{}-bit", type.basesize() * 8);
    }
}

std::string spaceOf(const OIIO::ImageSpec& spec) {
    std::string own = spec.get_string_attribute("texloom:space");
    if (!own.empty())
        return own;
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const bool linear =
        OIIO::Strutil::istarts_with(space, "lin") || OIIO::Strutil::iequals(space, "scene_linear");
    return linear || (space.empty() && spec.format.is_floating_point()) ? "linear" : "srgb";
}

std::string recipeOf(const OIIO::ImageSpec& spec) {
    std::string embedded = spec.get_string_attribute("texloom:recipe");
    if (!embedded.empty())
        return embedded;
    // TIFF has no place for attributes of one's own; there the description holds it.
    std::string description = spec.get_string_attribute("ImageDescription");
    return description.find("\"texloom\"") != std::string::npos ? description : std::string();
}

bool turned(const OIIO::ImageSpec& spec) {
    return spec.get_int_attribute("Orientation", 1) >= 5;
}

ImageFileInfo describe(const OIIO::ImageSpec& spec, const std::string& format) {
    ImageFileInfo info;
    info.size = turned(spec) ? Size{spec.height, spec.width} : Size{spec.width, spec.height};
    info.channels = spec.nchannels;
    info.format = format;
    info.depth = depthText(spec.format);
    info.space = spaceOf(spec);
    info.iccProfile = spec.get_string_attribute("ICCProfile:profile_description");
    info.recipe = recipeOf(spec);
    return info;
}

void checkSpec(const fs::path& path, const OIIO::ImageSpec& spec, std::int64_t largestPixels) {
    const std::int64_t pixels = Size{spec.width, spec.height}.area();
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
        fail("{} has no pixels.", path.string());
    if (pixels > largestPixels)
        fail("{} is {} × {} px; images up to {} pixels can be opened.", path.string(), spec.width,
             spec.height, grouped(static_cast<std::uint64_t>(largestPixels)));
    if (spec.nchannels > kMostChannels)
        fail("{} has {} channels; images with up to {} can be opened.", path.string(), spec.nchannels,
             kMostChannels);
    if (spec.deep || spec.depth > 1)
        fail("{} is a {} image; only flat ones can be opened.", path.string(),
             Message(spec.deep ? TR("deep") : TR("volume")));
}

/// Number of steps from 0 to 1 in integer samples; 0 for others.
float stepsOf(const OIIO::TypeDesc& type) {
    return type.basetype == OIIO::TypeDesc::UINT8    ? 255.0F
           : type.basetype == OIIO::TypeDesc::UINT16 ? 65535.0F
                                                     : 0.0F;
}

/// All samples, interleaved.
std::vector<float> readSamples(const fs::path& path, OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<float> samples(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, samples.data()))
        fail("{} cannot be read: {}.", path.string(), reason(input.geterror()));
    // A decoder may fill what is missing and only remark on it.
    if (const std::string remark = input.geterror(); !remark.empty())
        fail("{} cannot be read: {}.", path.string(), reason(remark));
    // The library multiplies by a rounded 1 / 255; this gives the nearest float to each step.
    if (const float steps = stepsOf(spec.format); steps > 0)
        for (float& sample : samples)
            sample = std::round(sample * steps) / steps;
    return samples;
}

/// Where a stored pixel is shown, by the eight orientations of the EXIF and TIFF standards.
Size shownAt(int x, int y, const OIIO::ImageSpec& spec) {
    const int fromRight = spec.width - 1 - x;
    const int fromBottom = spec.height - 1 - y;
    switch (spec.get_int_attribute("Orientation", 1)) {
    case 2:
        return {fromRight, y};
    case 3:
        return {fromRight, fromBottom};
    case 4:
        return {x, fromBottom};
    case 5:
        return {y, x};
    case 6:
        return {fromBottom, x};
    case 7:
        return {fromBottom, fromRight};
    case 8:
        return {y, fromRight};
    default:
        return {x, y};
    }
}

Image upright(const OIIO::ImageSpec& spec, const std::vector<float>& samples) {
    Image image(turned(spec) ? Size{spec.height, spec.width} : Size{spec.width, spec.height}, spec.nchannels);
    const float* sample = samples.data();
    const bool asStored = shownAt(0, 0, spec) == Size{0, 0} && !turned(spec);
    for (int y = 0; y < spec.height; ++y)
        for (int x = 0; x < spec.width; ++x) {
            const Size at = asStored ? Size{x, y} : shownAt(x, y, spec);
            for (int c = 0; c < spec.nchannels; ++c)
                image(at.width, at.height, c) = *sample++;
        }
    return image;
}

void checkFinite(const fs::path& path, const Image& image) {
    std::uint64_t broken = 0;
    Size first;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < image.channels(); ++c)
                if (!std::isfinite(image(x, y, c)) && broken++ == 0)
                    first = {x, y};
    if (broken > 0)
        fail("{} holds {} values that are not finite numbers, the first at pixel ({}, {}); save it without "
             "them.",
             path.string(), grouped(broken), first.width, first.height);
}

} // namespace

LoadedImage readImage(const fs::path& path, std::int64_t largestPixels) {
    const std::string format = formatOf(path);
    const auto input = openInput(path, format);
    checkSpec(path, input->spec(), largestPixels);
    LoadedImage loaded{upright(input->spec(), readSamples(path, *input)), describe(input->spec(), format)};
    checkFinite(path, loaded.image);
    return loaded;
}

ImageFileInfo readImageInfo(const fs::path& path) {
    const std::string format = formatOf(path);
    return describe(openInput(path, format)->spec(), format);
}

std::string readAttribute(const fs::path& path, const std::string& name) {
    return openInput(path, formatOf(path))->spec().get_string_attribute(name);
}

} // namespace texloom
