#pragma once

#include "core/image/image.h"
#include "core/volume/box.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace texloom {

/// A solid in memory: float32, one channel after the other, in each z after z, row after row. Values mean
/// what those of an Image mean. Copying copies the voxels.
class Volume {
public:
    Volume() = default;
    /// All samples 0. @throws Error if a side or the number of channels is below 1, or memory is short.
    Volume(const VolumeSize& size, int channels);

    const VolumeSize& size() const { return m_size; }
    int width() const { return m_size.width; }
    int height() const { return m_size.height; }
    int depth() const { return m_size.depth; }
    int channels() const { return m_channels; }
    bool empty() const { return m_data.empty(); }
    /// Bytes that a volume of this size takes; the largest number there is where that does not fit.
    static std::uint64_t bytesFor(const VolumeSize& size, int channels);

    float& operator()(int x, int y, int z, int channel) { return *at(x, y, z, channel); }
    float operator()(int x, int y, int z, int channel) const { return *at(x, y, z, channel); }
    /// The row of voxels (0 … width − 1, y, z).
    float* row(int y, int z, int channel) { return at(0, y, z, channel); }
    const float* row(int y, int z, int channel) const { return at(0, y, z, channel); }
    /// The picture at one z, x to the right and y down, without a copy.
    ImageView slice(int z) const {
        return {at(0, 0, z, 0), width(), height(), m_channels, width(), planeStride()};
    }

private:
    std::ptrdiff_t planeStride() const { return static_cast<std::ptrdiff_t>(m_size.voxels()); }
    std::ptrdiff_t index(int x, int y, int z, int channel) const {
        return channel * planeStride() + (static_cast<std::ptrdiff_t>(z) * m_size.height + y) * m_size.width +
               x;
    }
    float* at(int x, int y, int z, int channel) { return m_data.data() + index(x, y, z, channel); }
    const float* at(int x, int y, int z, int channel) const {
        return m_data.data() + index(x, y, z, channel);
    }

    VolumeSize m_size;
    int m_channels = 0;
    std::vector<float> m_data;
};

/// Whether both have the same size, channels and, sample for sample, the same values.
bool sameVoxels(const Volume& a, const Volume& b);

} // namespace texloom
