#pragma once

#include "core/base/message.h"
#include "core/color/file_color.h"
#include "core/image/image.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texloom {

/// What a file says of the image in it.
struct ImageFileInfo {
    Size size; ///< as shown: the file's orientation is applied
    int channels = 0;
    std::string format; ///< "png", "jpeg", "tiff", "openexr", "hdr"
    std::string depth;  ///< "8-bit", "16-bit", "32-bit", "half", "float"
    std::string
        space; ///< id of the colour space that the file says or its format implies: see color::spaces()
    /// The colours that the file's tags describe, where `space` is "file".
    std::optional<FileColor> color = {};
    std::string iccProfile; ///< name of the embedded profile, or empty
    std::string recipe;     ///< text of the embedded recipe, or empty
    std::string name = {};  ///< of the file, without its folder
    /// As the file has them ("R", "diffuse.R", "Z") or its format implies.
    std::vector<std::string> channelNames = {};
    bool associatedAlpha = false;         ///< whether the file's colours are multiplied by alpha
    std::string compression = {};         ///< as the decoder calls it; empty where the format has only one
    std::string layer = {};               ///< the part or layer that was asked for, or empty
    std::vector<std::string> layers = {}; ///< all that can be asked for; empty where there is one picture
    /// What someone should know of how the file was taken, in sentences.
    std::vector<Message> notes = {};
    /// Texts by which Texloom knows its own files: "Software" and those of "texloom:".
    std::map<std::string, std::string> texts = {};
};

/// Pixels with straight alpha (integers scaled to 0 to 1), and what the file says of them.
struct LoadedImage {
    Image image;
    ImageFileInfo info;
};

/// Whether pictures are written without the time of day, so that equal runs make equal files: EXR and TIFF
/// hold a date, which then is 1 January 1970. Where the environment says SOURCE_DATE_EPOCH, it is that time
/// in any case. For the whole process.
void setReproducible(bool reproducible);

/// How deep samples are written.
enum class Depth { Bits8, Bits16, Half, Float };

struct WriteOptions {
    Depth depth = Depth::Bits8;
    std::string space = "srgb"; ///< written into the file's metadata; the pixels are not converted
    /// Of an EXR, by which alpha is told, too; empty for those that the number of channels implies.
    std::vector<std::string> channelNames = {};
    bool compressed = true; ///< without loss; only a TIFF can do without, which is much quicker
    std::string recipe;     ///< embedded in PNG, EXR and, up to 64 KiB, TIFF; empty for none
    /// Further text attributes by name, such as "texloom:exemplars".
    std::vector<std::pair<std::string, std::string>> attributes;
    std::function<void()> check; ///< called for every row; what it throws ends the writing and leaves no file
};

/// More pixels than this in one file are refused.
inline constexpr std::int64_t kLargestFilePixels = 512LL << 20;

/// How a file is read.
struct ReadOptions {
    std::int64_t largestPixels = kLargestFilePixels;
    std::string layer = {}; ///< one of ImageFileInfo::layers; empty: the first part with all its channels
    bool data = false;      ///< whether the values are no colours, so that alpha leaves them alone
};

/// Reads PNG, JPEG, TIFF, OpenEXR and Radiance HDR: grey, colour, palette, any channels; told apart by their
/// first bytes, never by their names. The orientation is applied, and colours that the file holds multiplied
/// by alpha are divided by it. Programs that started a DecoderProcess decode there.
/// @throws Error in one sentence if the file is missing, not an image, broken, too large for what memory is
/// left, or holds values that are not finite; UsageError if it has no such layer.
LoadedImage readImage(const std::filesystem::path& path, const ReadOptions& options = {});

/// What readImage() would find, from the header alone. @throws Error as readImage()
ImageFileInfo readImageInfo(const std::filesystem::path& path, const std::string& layer = {});

/// One of ImageFileInfo::texts, or empty. @throws Error as readImage()
std::string readAttribute(const std::filesystem::path& path, const std::string& name);

/// Makes one row of samples, interleaved by channel; called for y = 0, 1, … in order.
using RowSource = std::function<void(int y, float* row)>;

/// Writes an image to a temporary file beside `path` and renames it: `path` holds the whole image or what it
/// held before. The format follows from the name: .png .jpg .jpeg .tif .tiff .exr .hdr.
/// @throws Error or UsageError if the format cannot hold the image or the file cannot be written.
void writeImage(const std::filesystem::path& path, const ImageView& image, const WriteOptions& options);
/// The same for an image that is made row by row, so that it is never in memory whole.
void writeImage(const std::filesystem::path& path, Size size, int channels, const RowSource& rows,
                const WriteOptions& options);

/// Checks that the folder of `path` is there and can be written to. @throws Error
void checkFolder(const std::filesystem::path& path);

/// Checks that `path` can be written before a long run: known format, channels it can hold, folder there and
/// writable.
/// @throws Error or UsageError
void checkWritable(const std::filesystem::path& path, int channels, Depth depth);

/// The depths that a file format holds, best for textures first. @param path only its extension counts.
std::vector<Depth> depthsFor(const std::filesystem::path& path);

/// "8-bit", "16-bit", "half" or "float".
std::string_view depthName(Depth depth);

/// SHA-1 of a file's bytes in hexadecimal. @throws Error if it cannot be read.
std::string fileHash(const std::filesystem::path& path);
/// The same of bytes in memory.
std::string bytesHash(std::string_view bytes);

/// Writes text as writeImage() does: whole or not at all. @throws Error
void writeText(const std::filesystem::path& path, std::string_view text);
/// @throws Error if it cannot be read or is larger than `largestBytes`.
std::string readText(const std::filesystem::path& path, std::uintmax_t largestBytes = 16U << 20);

} // namespace texloom
