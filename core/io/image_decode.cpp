#include "core/io/image_decode.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/color_tags.h"
#include "core/io/file_part.h"
#include "core/io/header_check.h"
#include "core/io/image_describe.h"
#include "core/io/jpeg_scans.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

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

/// The first line of what the library says, without a closing stop.
std::string reason(std::string message) {
    message = message.substr(0, message.find('\n'));
    while (!message.empty() && (message.back() == '.' || message.back() == ' '))
        message.pop_back();
    return message.empty() ? "the file is damaged" : message;
}

std::unique_ptr<OIIO::ImageInput> openInput(const fs::path& path, const std::string& format) {
    checkHeader(path, format);
    auto input = OIIO::ImageInput::create(format);
    if (!input)
        fail("{} cannot be read: this build has no reader for {}.", path.string(), format);
    OIIO::ImageSpec spec, config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(path.string(), spec, config))
        fail("{} cannot be read: {}.", path.string(), reason(input->geterror()));
    return input;
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
int stepsOf(const OIIO::TypeDesc& type) {
    return type.basetype == OIIO::TypeDesc::UINT8 ? 255 : type.basetype == OIIO::TypeDesc::UINT16 ? 65535 : 0;
}

void checkRoom(const DecodeRequest& request, const DecodedHeader& header) {
    // Once as they come from the decoder, once as an image.
    const std::uint64_t needed = 2 * header.samples * sizeof(float);
    if (request.memory > 0 && needed > request.memory)
        fail("{} is {} × {} px with {} channels and takes {} of memory to read, more than {}; scale it down "
             "or cut it to size first.",
             request.path.string(), header.stored.width, header.stored.height, header.info.channels,
             byteText(needed), request.memoryText);
}

/// How many bytes one of a file's bytes can stand for at most, by its compression; 0 for no bound.
std::uintmax_t densityOf(const OIIO::ImageSpec& spec, const std::string& format) {
    const std::string kind = spec.get_string_attribute("compression");
    if (kind == "none")
        return 1;
    if (kind == "packbits")
        return 64;
    return format == "png" || kind == "zip" || kind == "zips" || kind == "lzw" ? 2000 : 0;
}

/// A decoder fills what a file cut short claims to hold, which takes minutes where that is much.
void checkBytes(const fs::path& path, const OIIO::ImageSpec& spec, const std::string& format) {
    // Of a palette the first is what the file has, the second what it stands for.
    const int decoded =
        spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(8 * spec.format.size()));
    const int bits = spec.get_int_attribute("tiff:BitsPerSample", decoded);
    const auto pixels = static_cast<std::uintmax_t>(Size{spec.width, spec.height}.area());
    const std::uintmax_t least =
        pixels * static_cast<std::uintmax_t>(std::max(bits, 1)) / 8; // of one channel
    std::error_code error;
    const std::uintmax_t held = fs::file_size(path, error), density = densityOf(spec, format);
    if (!error && density > 0 && least / density > held)
        fail("{} says it is {} × {} px, but has only {} bytes: it is cut short or damaged.", path.string(),
             spec.width, spec.height, grouped(held));
}

/// Stray bytes between a JPEG's parts harm nothing; every viewer skips them.
bool harmless(const std::string& remark, const std::string& format) {
    std::istringstream lines(remark);
    for (std::string line; std::getline(lines, line);)
        if (line.find("extraneous bytes before marker") == std::string::npos)
            return false;
    return format == "jpeg";
}

/// A decoder may fill what is missing and only remark on it.
void takeRemark(const fs::path& path, const std::string& remark, ImageFileInfo& info) {
    if (remark.empty())
        return;
    if (!harmless(remark, info.format))
        fail("{} cannot be read: {}.", path.string(), reason(remark));
    info.notes.push_back(message("{} holds stray bytes, which were skipped.", info.name));
}

[[noreturn]] void failReading(const fs::path& path, const std::string& format, const std::string& why) {
    if (format == "hdr")
        fail("{} cannot be read: its pixels are damaged, or packed in the old-style RLE of Radiance, which "
             "Texloom does not read. Save it again with another program.",
             path.string());
    fail("{} cannot be read: {}.", path.string(), reason(why));
}

/// What an ImageInput is to fill with a part's samples, interleaved.
struct SampleTarget {
    const FilePart& part;
    OIIO::TypeDesc type;
    float* samples;
};

bool fill(OIIO::ImageInput& input, const SampleTarget& target) {
    return input.read_image(target.part.index, 0, target.part.firstChannel,
                            target.part.firstChannel + target.part.channels, target.type, target.samples);
}

/// Reads a JPEG that breaks off as though its end marker stood there: of rows that are missing, too, the
/// decoder says so then, and of nothing else; that whole scans are missing it does not. @return its remark
std::string filledWithEnd(const DecodeRequest& request, const SampleTarget& target) {
    std::ifstream file(request.path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!hasAllScans(bytes))
        fail(
            "{} breaks off before the last of its scans, so that its picture lacks detail or colours; take a "
            "whole copy of it.",
            request.path.string());
    bytes += "\xff\xd9";
    OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::create("jpeg");
    OIIO::ImageSpec spec;
    if (!input || !input->set_ioproxy(&reader) || !input->open(request.path.string(), spec) ||
        !fill(*input, target))
        failReading(request.path, "jpeg", input ? input->geterror() : std::string());
    return input->geterror();
}

/// Whether a decoder misses the end of a JPEG.
bool breaksOff(const std::string& format, const std::string& remark) {
    return format == "jpeg" && remark.find("Premature end of JPEG file") != std::string::npos;
}

/// Reads all samples. @param cut whether it is known that the file breaks off. @return the decoder's remark
/// on what it filled by itself
std::string filled(const DecodeRequest& request, OIIO::ImageInput& input, const SampleTarget& target,
                   ImageFileInfo& info, bool cut) {
    const bool read = fill(input, target);
    std::string remark = input.geterror();
    if (cut || breaksOff(info.format, remark)) {
        remark = filledWithEnd(request, target);
        info.notes.push_back(
            message("{} breaks off before its end marker, but all of its rows are there.", info.name));
    } else if (!read) {
        failReading(request.path, info.format, remark);
    }
    return remark;
}

/// Whole numbers of 32 bits say nothing of what is white: the largest one in the file is taken for it.
template <class Number> void scaleToSpan(float* samples, std::size_t count, DecodedHeader& header) {
    const auto at = [samples](std::size_t i) {
        Number number;
        std::memcpy(&number, samples + i, sizeof(number));
        return static_cast<double>(number);
    };
    double least = 0, most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        least = std::min(least, at(i));
        most = std::max(most, at(i));
    }
    const double span = most > least ? most - least : 1;
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<float>((at(i) - least) / span);
    header.info.notes.push_back(
        message("{} holds whole numbers of 32 bits from {:.0f} to {:.0f}, which are taken as 0 to 1.",
                header.info.name, least, most));
}

/// All samples of a part's channels, interleaved. @param cut as of filled()
void readSamples(const DecodeRequest& request, OIIO::ImageInput& input, const FilePart& part,
                 DecodedHeader& header, float* samples, bool cut) {
    const OIIO::TypeDesc stored = input.spec().format;
    const bool wide = stored.basetype == OIIO::TypeDesc::UINT32 || stored.basetype == OIIO::TypeDesc::INT32;
    const SampleTarget target{part, wide ? stored : OIIO::TypeDesc::FLOAT, samples};
    takeRemark(request.path, filled(request, input, target, header.info, cut), header.info);
    if (stored.basetype == OIIO::TypeDesc::UINT32)
        scaleToSpan<std::uint32_t>(samples, header.samples, header);
    else if (wide)
        scaleToSpan<std::int32_t>(samples, header.samples, header);
}

/// The EXIF orientation. Of Radiance pictures that are stored by columns, "+X N +Y M" is turned to the right
/// in the file and "-X N -Y M" to the left (Ward, Radiance File Formats); the library has it the other way
/// around.
int orientationOf(const OIIO::ImageSpec& spec, const std::string& format) {
    constexpr int kToTheRight = 6, kToTheLeft = 8; // what is to be done
    const int told = spec.get_int_attribute("Orientation", 1);
    if (format == "hdr" && (told == kToTheRight || told == kToTheLeft))
        return kToTheRight + kToTheLeft - told;
    return told;
}

/// An EXR may hold pixels around or within the picture that it is meant to show.
void noteWindow(ImageFileInfo& info, const OIIO::ImageSpec& spec) {
    const bool same = spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
                      spec.height == spec.full_height;
    if (info.format == "openexr" && !same)
        info.notes.push_back(message("{} holds {} × {} px from ({}, {}) on, but is meant to show {} × {} "
                                     "px from ({}, {}) on; all that it "
                                     "holds is used.",
                                     info.name, spec.width, spec.height, spec.x, spec.y, spec.full_width,
                                     spec.full_height, spec.full_x, spec.full_y));
}

} // namespace

DecodedHeader decode(const DecodeRequest& request, const SamplePlace& place) {
    const std::string format = formatOf(request.path);
    const auto input = openInput(request.path, format);
    const std::string remark = input->geterror(); // before looking for parts drops it
    const std::vector<FilePart> parts = partsOf(*input);
    if (parts.empty())
        fail("{} cannot be read: {}.", request.path.string(), reason(input->geterror()));
    const FilePart part = chosenPart(request.path, parts, request.layer);
    input->seek_subimage(part.index, 0);
    const OIIO::ImageSpec spec = input->spec();
    DecodedHeader header;
    header.info = describe(spec, format);
    header.info.name = request.path.filename().string();
    takeColorTags(header.info, spec, request.path);
    noteWindow(header.info, spec);
    takePart(header.info, part, parts, request.layer);
    header.stored = {spec.width, spec.height};
    header.orientation = orientationOf(spec, format);
    if (!request.pixels)
        return header;
    checkSpec(request.path, spec, request.largestPixels);
    checkBytes(request.path, spec, format);
    header.steps = stepsOf(spec.format);
    header.samples = spec.image_pixels() * static_cast<std::size_t>(part.channels);
    checkRoom(request, header);
    const bool cut = breaksOff(format, remark); // progressive ones are looked through when they are opened
    if (!cut)
        takeRemark(request.path, remark, header.info);
    readSamples(request, *input, part, header, place(header.samples), cut);
    return header;
}

} // namespace texloom
