#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/channel_names.h"
#include "core/io/decoder_process.h"
#include "core/io/image_file.h"
#include "core/job/memory.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// A file's samples, wherever they are.
struct Samples {
    DecodedHeader header;
    SharedSamples shared;
    std::vector<float> own;
    const float* first = nullptr;
};

Samples decoded(const fs::path& path, const ReadOptions& options, bool pixels) {
    constexpr std::uint64_t kForHeader = 512U << 20;
    DecodeRequest request{path, pixels, options.layer, options.largestPixels, kForHeader, {}};
    if (pixels) {
        request.memory = availableMemory();
        request.memoryText = availableMemoryText();
    }
    Samples samples;
    if (DecoderProcess::running()) {
        DecoderProcess::Decoded there = DecoderProcess::decode(request);
        samples.header = std::move(there.header);
        samples.shared = std::move(there.memory);
        samples.first = there.samples;
        return samples;
    }
    samples.header = decode(request, [&samples](std::size_t count) {
        samples.own.resize(count);
        return samples.own.data();
    });
    samples.first = samples.own.data();
    return samples;
}

/// Where a stored pixel is shown, by the eight orientations of the EXIF and TIFF standards.
Size shownAt(int x, int y, const DecodedHeader& header) {
    const int fromRight = header.stored.width - 1 - x;
    const int fromBottom = header.stored.height - 1 - y;
    switch (header.orientation) {
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

Image upright(const DecodedHeader& header, const float* sample) {
    Image image(header.info.size, header.info.channels);
    const bool asStored =
        shownAt(0, 0, header) == Size{0, 0} && header.info.size == header.stored && header.orientation < 5;
    const auto steps = static_cast<float>(header.steps);
    for (int y = 0; y < header.stored.height; ++y) {
        DecoderProcess::check();
        for (int x = 0; x < header.stored.width; ++x) {
            const Size at = asStored ? Size{x, y} : shownAt(x, y, header);
            // The library multiplies by a rounded 1 / 255; this gives the nearest float to each step.
            for (int c = 0; c < image.channels(); ++c, ++sample)
                image(at.width, at.height, c) = steps > 0 ? std::round(*sample * steps) / steps : *sample;
        }
    }
    return image;
}

/// Colours as they are in front of nothing. Where alpha is 0, what is there adds light, and stays.
void divideByAlpha(Image& image, const AlphaGroup& group, int steps) {
    for (int y = 0; y < image.height(); ++y) {
        DecoderProcess::check();
        for (int x = 0; x < image.width(); ++x)
            if (const float alpha = image(x, y, group.alpha); alpha > 0)
                for (const int c : group.colours) {
                    const float colour = image(x, y, c) / alpha;
                    image(x, y, c) = steps > 0 ? std::min(colour, 1.0F) : colour;
                }
    }
}

void checkFinite(const fs::path& path, const Image& image) {
    std::uint64_t broken = 0;
    Size first;
    for (int y = 0; y < image.height(); ++y) {
        DecoderProcess::check();
        for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < image.channels(); ++c)
                if (!std::isfinite(image(x, y, c)) && broken++ == 0)
                    first = {x, y};
    }
    if (broken > 0)
        fail("{} holds {} values that are not finite numbers, the first at pixel ({}, {}); save it without "
             "them.",
             path.string(), grouped(broken), first.width, first.height);
}

} // namespace

LoadedImage readImage(const fs::path& path, const ReadOptions& options) {
    const Samples samples = decoded(path, options, true);
    const DecodedHeader& header = samples.header;
    LoadedImage loaded{upright(header, samples.first), header.info};
    checkFinite(path, loaded.image);
    if (header.info.associatedAlpha && !options.data && header.info.space != "raw")
        for (const AlphaGroup& group : alphaGroups(header.info.channelNames))
            divideByAlpha(loaded.image, group, header.steps);
    return loaded;
}

ImageFileInfo readImageInfo(const fs::path& path, const std::string& layer) {
    return decoded(path, {kLargestFilePixels, layer, false}, false).header.info;
}

std::string readAttribute(const fs::path& path, const std::string& name) {
    const std::map<std::string, std::string> texts = readImageInfo(path).texts;
    const auto found = texts.find(name);
    return found == texts.end() ? std::string() : found->second;
}

} // namespace texloom
