#include "core/image/image.h"

#include "core/base/error.h"
#include "core/base/large_memory.h"
#include "core/base/text.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace texloom {

namespace {

constexpr int kAlignedFloats = 64 / sizeof(float);

std::ptrdiff_t alignedRow(int width) {
    return (static_cast<std::ptrdiff_t>(width) + kAlignedFloats - 1) / kAlignedFloats * kAlignedFloats;
}

/// Memory for an image, zero if it is large.
float* allocated(Size size, int channels) {
    if (size.empty() || channels < 1)
        fail("An image of {} × {} px with {} channels has no pixels.", size.width, size.height, channels);
    const std::uint64_t bytes = Image::bytesFor(size, channels);
    try {
        return static_cast<float*>(allocateMemory(bytes));
    } catch (const std::bad_alloc&) {
        fail("There is not enough memory for an image of {} × {} px with {} channels ({}).", size.width,
             size.height, channels, byteText(bytes));
    }
}

} // namespace

void Image::Free::operator()(float* data) const {
    freeMemory(data, bytes);
}

std::uint64_t Image::bytesFor(Size size, int channels) {
    return static_cast<std::uint64_t>(alignedRow(size.width)) * static_cast<std::uint64_t>(size.height) *
           static_cast<std::uint64_t>(channels) * sizeof(float);
}

Image::Image(Size size, int channels)
    : m_size(size), m_channels(channels), m_rowStride(alignedRow(size.width)),
      m_planeStride(m_rowStride * size.height),
      m_data(allocated(size, channels), {bytesFor(size, channels)}) {
    if (bytesFor(size, channels) < kLargeMemory)
        std::fill_n(m_data.get(), m_planeStride * channels, 0.0F);
}

Image::Image(const ImageView& view)
    : m_size(view.size()), m_channels(view.channels), m_rowStride(alignedRow(view.width)),
      m_planeStride(m_rowStride * view.height),
      m_data(allocated(view.size(), view.channels), {bytesFor(view.size(), view.channels)}) {
    for (int c = 0; c < m_channels; ++c)
        for (int y = 0; y < height(); ++y) {
            float* end = std::copy_n(view.plane(c).row(y), width(), plane(c).row(y));
            std::fill_n(end, m_rowStride - width(), 0.0F);
        }
}

Image::Image(const Image& other) {
    if (!other.empty())
        *this = Image(other.view());
}

Image& Image::operator=(const Image& other) {
    if (this != &other)
        *this = Image(other);
    return *this;
}

void Image::shrink(Size size) {
    m_size = {std::min(size.width, width()), std::min(size.height, height())};
}

ValueRange valueRange(const ImageView& image) {
    ValueRange range{image(0, 0, 0), image(0, 0, 0)};
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y) {
            const float* row = image.plane(c).row(y);
            const auto [low, high] = std::minmax_element(row, row + image.width);
            range = {std::min(range.smallest, *low), std::max(range.largest, *high)};
        }
    return range;
}

Image stacked(std::span<const ImageView> images) {
    int channels = 0;
    for (const ImageView& image : images)
        channels += image.channels;
    Image stack(images.front().size(), channels);
    int to = 0;
    for (const ImageView& image : images)
        for (int c = 0; c < image.channels; ++c, ++to)
            for (int y = 0; y < stack.height(); ++y)
                std::copy_n(image.plane(c).row(y), stack.width(), stack.plane(to).row(y));
    return stack;
}

std::vector<double> channelMeans(const ImageView& image, const std::function<void()>& check) {
    std::vector<double> means(static_cast<std::size_t>(image.channels));
    for (int c = 0; c < image.channels; ++c) {
        double sum = 0;
        for (int y = 0; y < image.height; ++y) {
            check();
            const float* row = image.plane(c).row(y);
            for (int x = 0; x < image.width; ++x)
                sum += static_cast<double>(row[x]);
        }
        means[static_cast<std::size_t>(c)] = sum / static_cast<double>(image.size().area());
    }
    return means;
}

bool samePixels(const ImageView& a, const ImageView& b) {
    if (a.size() != b.size() || a.channels != b.channels)
        return false;
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y)
            if (!std::equal(a.plane(c).row(y), a.plane(c).row(y) + a.width, b.plane(c).row(y)))
                return false;
    return true;
}

} // namespace texloom
