#pragma once

#include "core/io/image_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace texloom {

/// What is asked of a decoder.
struct DecodeRequest {
    std::filesystem::path path;
    bool pixels = true;     ///< or the header alone
    std::string layer = {}; ///< as ReadOptions::layer
    std::int64_t largestPixels = kLargestFilePixels;
    std::uint64_t memory = 0; ///< most bytes to read with; 0 for any number
    Message memoryText = {};  ///< the same in words: "the 63 MiB that are free"
};

/// A file's header, as the decoder found it, and how the samples behind it are to be taken.
struct DecodedHeader {
    ImageFileInfo info;
    Size stored;         ///< before the orientation is applied
    int orientation = 1; ///< 1 to 8, of the EXIF and TIFF standards
    int steps = 0;       ///< from 0 to 1 in integer samples; 0 for others
    std::size_t samples = 0;

    /// As text that fromJson() reads, for another process.
    std::string toJson() const;
    static DecodedHeader fromJson(const std::string& text);
};

/// Gives the place for all samples, interleaved by channel.
using SamplePlace = std::function<float*(std::size_t samples)>;

/// Reads a file in this process. A damaged file may end the process, since some of the libraries underneath
/// abort: programs read through a DecoderProcess.
/// @throws Error as readImage()
DecodedHeader decode(const DecodeRequest& request, const SamplePlace& place);

} // namespace texloom
