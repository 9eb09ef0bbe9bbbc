#pragma once

#include "core/base/at.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace texloom {

/// Feature maps: channels × height × width numbers, one channel after another, row by row, without gaps.
/// Keeps its memory when it becomes smaller, so that one that is used again takes none.
class Tensor {
public:
    Tensor() = default;
    /// All 0. @param channels, height and width at least 0.
    Tensor(int channels, int height, int width) { resize(channels, height, width); }

    /// Another shape. What it holds then is of no meaning.
    void resize(int channels, int height, int width) {
        m_channels = channels;
        m_height = height;
        m_width = width;
        if (m_values.size() < size() + kSlack)
            m_values.resize(size() + kSlack);
    }
    /// All that its shape holds becomes 0.
    void clear() { std::fill_n(data(), size(), 0.0F); }

    int channels() const { return m_channels; }
    int height() const { return m_height; }
    int width() const { return m_width; }
    /// Numbers in one channel.
    std::size_t area() const { return texloom::at(m_height) * texloom::at(m_width); }
    std::size_t size() const { return texloom::at(m_channels) * area(); }
    bool sameShape(const Tensor& other) const {
        return m_channels == other.m_channels && m_height == other.m_height && m_width == other.m_width;
    }

    /// So many numbers beyond the last may be read and written: inner loops need not stop exactly.
    static constexpr std::size_t kSlack = 64;

    float* data() { return m_values.data(); }
    const float* data() const { return m_values.data(); }
    float* channel(int c) { return data() + texloom::at(c) * area(); }
    const float* channel(int c) const { return data() + texloom::at(c) * area(); }
    float* row(int c, int y) { return channel(c) + texloom::at(y) * texloom::at(m_width); }
    const float* row(int c, int y) const { return channel(c) + texloom::at(y) * texloom::at(m_width); }

private:
    int m_channels = 0, m_height = 0, m_width = 0;
    std::vector<float> m_values;
};

} // namespace texloom
