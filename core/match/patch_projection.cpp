#include "core/match/patch_projection.h"

#include "core/base/wide_vectors.h"

#include <algorithm>
#include <vector>

namespace texloom {

namespace {

TEXLOOM_WIDE_VECTORS
void addScaled(float factor, const float* from, int count, float* to) {
    for (int i = 0; i < count; ++i)
        to[i] += factor * from[i];
}

/// addScaled() for four factors of neighbouring samples, one after the other, to the same bits.
TEXLOOM_WIDE_VECTORS
void addFourScaled(const float* factors, const float* from, int count, float* to) {
    const float first = factors[0], second = factors[1], third = factors[2], fourth = factors[3];
    for (int i = 0; i < count; ++i)
        to[i] =
            (((to[i] + first * from[i]) + second * from[i + 1]) + third * from[i + 2]) + fourth * from[i + 3];
}

} // namespace

PatchProjection::PatchProjection(Size image, Wrap wrap, int patch)
    : m_size(image), m_wrap(wrap),
      m_patch(patch), m_positions{wrap.x ? image.width : image.width - patch + 1,
                                  wrap.y ? image.height : image.height - patch + 1} {}

void PatchProjection::pad(Image& image) const {
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y) {
            float* row = image.plane(c).row(y);
            if (y < m_size.height && image.width() == m_size.width)
                continue;
            if (y >= m_size.height)
                std::copy_n(image.plane(c).row(y % m_size.height), m_size.width, row);
            for (int x = m_size.width; x < image.width(); ++x)
                row[x] = row[x % m_size.width];
        }
}

void PatchProjection::projectRow(const Image& padded, std::span<const float> direction, int y,
                                 float* to) const {
    std::fill_n(to, m_positions.width, 0.0F);
    const float* factor = direction.data();
    for (int c = 0; c < padded.channels(); ++c)
        for (int dy = 0; dy < m_patch; ++dy) {
            const float* from = padded.plane(c).row(y + dy);
            int dx = 0;
            for (; dx + 4 <= m_patch; dx += 4, factor += 4)
                addFourScaled(factor, from + dx, m_positions.width, to);
            for (; dx < m_patch; ++dx)
                addScaled(*factor++, from + dx, m_positions.width, to);
        }
}

void PatchProjection::spreadRow(const Image& numbers, std::span<const float> directions, int channel,
                                int channels, int y, float* to) const {
    std::vector<float> row(static_cast<std::size_t>(padded().width), 0.0F);
    const auto square = static_cast<std::size_t>(m_patch) * static_cast<std::size_t>(m_patch);
    for (int k = 0; k < numbers.channels(); ++k)
        for (int dy = 0; dy < m_patch; ++dy) {
            int from = y - dy;
            if (from < 0 && m_wrap.y)
                from += m_size.height;
            if (from < 0 || from >= m_positions.height)
                continue;
            const std::size_t first = (static_cast<std::size_t>(k) * static_cast<std::size_t>(channels) +
                                       static_cast<std::size_t>(channel)) *
                                          square +
                                      static_cast<std::size_t>(dy) * static_cast<std::size_t>(m_patch);
            for (int dx = 0; dx < m_patch; ++dx)
                addScaled(directions[first + static_cast<std::size_t>(dx)], numbers.plane(k).row(from),
                          m_positions.width, row.data() + dx);
        }
    for (std::size_t x = 0; x < row.size(); ++x)
        to[x % static_cast<std::size_t>(m_size.width)] += row[x];
}

int PatchProjection::coveringAlong(int at, int length, int patch, bool wraps) {
    return wraps ? patch : std::min({at + 1, length - at, patch, length - patch + 1});
}

int PatchProjection::covering(int x, int y) const {
    return coveringAlong(x, m_size.width, m_patch, m_wrap.x) *
           coveringAlong(y, m_size.height, m_patch, m_wrap.y);
}

} // namespace texloom
