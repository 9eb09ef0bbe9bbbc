#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

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
    if (!fs::exists(path))
        fail("There is no file {}.", path.string());
    if (fs::is_directory(path))
        fail("{} is a folder, not an image.", path.string());
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

/// The first line of what the library says, without a closing stop.
std::string reason(std::string message) {
    message = message.substr(0, message.find('\n'));
    while (!message.empty() && (message.back() == '.' || message.back() == ' '))
        message.pop_back();
    return message.empty() ? "the file is damaged" : message;
}

std::unique_ptr<OIIO::ImageInput> openInput(const fs::path& path, const std::string& format) {
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
        fail("{} is a {} image; only flat ones can be opened.", path.string(), spec.deep ? "deep" : "volume");
}

OIIO::ImageBuf readPixels(const fs::path& path, OIIO::ImageInput& input) {
    OIIO::ImageSpec spec = input.spec();
    spec.set_format(OIIO::TypeDesc::FLOAT);
    spec.x = spec.y = spec.full_x = spec.full_y = 0;
    spec.full_width = spec.width;
    spec.full_height = spec.height;
    OIIO::ImageBuf pixels(spec);
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.localpixels()))
        fail("{} cannot be read: {}.", path.string(), reason(input.geterror()));
    // A decoder may fill what is missing and only remark on it.
    if (const std::string remark = input.geterror(); !remark.empty())
        fail("{} cannot be read: {}.", path.string(), reason(remark));
    return spec.get_int_attribute("Orientation", 1) == 1 ? pixels : OIIO::ImageBufAlgo::reorient(pixels);
}

Image planar(const fs::path& path, const OIIO::ImageBuf& pixels) {
    const OIIO::ImageSpec& spec = pixels.spec();
    Image image({spec.width, spec.height}, spec.nchannels);
    const auto* samples = static_cast<const float*>(pixels.localpixels());
    std::uint64_t broken = 0;
    Size firstBroken;
    for (int y = 0; y < spec.height; ++y)
        for (int x = 0; x < spec.width; ++x)
            for (int c = 0; c < spec.nchannels; ++c) {
                const float sample = *samples++;
                image(x, y, c) = sample;
                if (!std::isfinite(sample) && broken++ == 0)
                    firstBroken = {x, y};
            }
    if (broken > 0)
        fail("{} holds {} values that are not finite numbers, the first at pixel ({}, {}); Texloom needs "
             "finite ones.",
             path.string(), grouped(broken), firstBroken.width, firstBroken.height);
    return image;
}

} // namespace

LoadedImage readImage(const fs::path& path, std::int64_t largestPixels) {
    const std::string format = formatOf(path);
    const auto input = openInput(path, format);
    checkSpec(path, input->spec(), largestPixels);
    const ImageFileInfo info = describe(input->spec(), format);
    return {planar(path, readPixels(path, *input)), info};
}

ImageFileInfo readImageInfo(const fs::path& path) {
    const std::string format = formatOf(path);
    return describe(openInput(path, format)->spec(), format);
}

std::string readAttribute(const fs::path& path, const std::string& name) {
    return openInput(path, formatOf(path))->spec().get_string_attribute(name);
}

} // namespace texloom
