#pragma once

#include "core/base/at.h"
#include "core/volume/box.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace texloom {

/// Feature maps of a box: channels × depth × height × width numbers, with gaps, so that the same neighbour is
/// at the same distance everywhere: rows are `row` numbers apart, planes `plane`, channels `channel`. Keeps
/// its memory when it becomes smaller.
class Field {
public:
    /// So many numbers behind a plane may be written: inner loops need not stop exactly.
    static constexpr int kSlack = 64;

    /// Another shape; what it holds then is of no meaning. @param rowLength at least the width.
    void resize(int channels, const VolumeSize& size, int rowLength) {
        m_channels = channels;
        m_size = size;
        m_row = rowLength;
        m_plane = static_cast<std::ptrdiff_t>(rowLength) * size.height + kSlack;
        const std::size_t wanted = at(channels) * static_cast<std::size_t>(channelStride()) + 2 * kSlack;
        if (m_values.size() < wanted)
            m_values.resize(wanted);
    }
    void clear() { std::fill(m_values.begin(), m_values.end(), 0.0F); }

    int channels() const { return m_channels; }
    const VolumeSize& size() const { return m_size; }
    int rowStride() const { return m_row; }
    std::ptrdiff_t planeStride() const { return m_plane; }
    std::ptrdiff_t channelStride() const { return m_plane * m_size.depth; }

    float* row(int c, int y, int z) {
        return m_values.data() + c * channelStride() + z * m_plane + static_cast<std::ptrdiff_t>(y) * m_row;
    }
    const float* row(int c, int y, int z) const {
        return m_values.data() + c * channelStride() + z * m_plane + static_cast<std::ptrdiff_t>(y) * m_row;
    }

private:
    int m_channels = 0;
    VolumeSize m_size;
    int m_row = 0;
    std::ptrdiff_t m_plane = 0;
    std::vector<float> m_values;
};

} // namespace texloom
