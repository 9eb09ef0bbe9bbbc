#pragma once

#include "core/image/size.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace texloom {

/// Read access to one channel: `height` rows of `width` floats, `stride` floats apart. Owns nothing.
struct PlaneView {
    const float* data = nullptr;
    int width = 0;
    int height = 0;
    std::ptrdiff_t stride = 0;

    const float* row(int y) const { return data + y * stride; }
    float operator()(int x, int y) const { return row(y)[x]; }
};

/// Write access to one channel; see PlaneView.
struct PlaneSpan {
    float* data = nullptr;
    int width = 0;
    int height = 0;
    std::ptrdiff_t stride = 0;

    float* row(int y) const { return data + y * stride; }
    float& operator()(int x, int y) const { return row(y)[x]; }
    operator PlaneView() const { return {data, width, height, stride}; }
};

/// Read access to all channels of an image, or of a rectangle in one, without a copy. Owns nothing.
struct ImageView {
    const float* data = nullptr;
    int width = 0;
    int height = 0;
    int channels = 0;
    std::ptrdiff_t rowStride = 0;
    std::ptrdiff_t planeStride = 0;

    Size size() const { return {width, height}; }
    PlaneView plane(int channel) const { return {data + channel * planeStride, width, height, rowStride}; }
    float operator()(int x, int y, int channel) const {
        return data[channel * planeStride + y * rowStride + x];
    }
    /// `count` channels from `first` on.
    ImageView channelRange(int first, int count) const {
        return {data + first * planeStride, width, height, count, rowStride, planeStride};
    }
    /// The rectangle of `extent` pixels whose top left is (x, y); it must lie within the view.
    ImageView crop(int x, int y, Size extent) const {
        return {data + y * rowStride + x, extent.width, extent.height, channels, rowStride, planeStride};
    }
};

/// A picture in memory: planar float32, any number of channels, rows aligned to 64 bytes for SIMD.
/// Colour values are those of the working space (0 to 1 for what a screen can show, no upper bound);
/// data channels hold their values as the file gave them. Copying copies the pixels.
class Image {
public:
    Image() = default;
    /// All samples 0. @throws Error if a side or the number of channels is below 1, or memory is short.
    Image(Size size, int channels);
    explicit Image(const ImageView& view);
    Image(const Image& other);
    Image(Image&&) noexcept = default;
    Image& operator=(const Image& other);
    Image& operator=(Image&&) noexcept = default;
    ~Image() = default;

    Size size() const { return m_size; }
    int width() const { return m_size.width; }
    int height() const { return m_size.height; }
    int channels() const { return m_channels; }
    bool empty() const { return m_size.empty(); }
    /// Bytes that an image of this size takes.
    static std::uint64_t bytesFor(Size size, int channels);

    PlaneSpan plane(int channel) {
        return {m_data.get() + channel * m_planeStride, width(), height(), m_rowStride};
    }
    PlaneView plane(int channel) const {
        return {m_data.get() + channel * m_planeStride, width(), height(), m_rowStride};
    }
    float& operator()(int x, int y, int channel) {
        return m_data[static_cast<std::size_t>(channel * m_planeStride + y * m_rowStride + x)];
    }
    float operator()(int x, int y, int channel) const {
        return m_data[static_cast<std::size_t>(channel * m_planeStride + y * m_rowStride + x)];
    }
    ImageView view() const {
        return {m_data.get(), width(), height(), m_channels, m_rowStride, m_planeStride};
    }
    operator ImageView() const { return view(); }

    /// Keeps the top left `size` pixels, in place: nothing is moved or freed.
    void shrink(Size size);

private:
    struct Free {
        std::uint64_t bytes;
        void operator()(float* data) const;
    };

    Size m_size;
    int m_channels = 0;
    std::ptrdiff_t m_rowStride = 0;
    std::ptrdiff_t m_planeStride = 0;
    std::unique_ptr<float[], Free> m_data;
};

/// The channels of all images, which have the same size, in one image.
Image stacked(std::span<const ImageView> images);

/// Smallest and largest sample over all channels. The view must not be empty.
struct ValueRange {
    float smallest = 0;
    float largest = 0;
};
ValueRange valueRange(const ImageView& image);

/// The mean of each channel. @param check called for every row; may throw.
std::vector<double> channelMeans(
    const ImageView& image, const std::function<void()>& check = [] {});

/// Whether both have the same size, channels and, sample for sample, the same values.
bool samePixels(const ImageView& a, const ImageView& b);

} // namespace texloom
