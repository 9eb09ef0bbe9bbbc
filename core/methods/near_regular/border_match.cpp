#include "core/methods/near_regular/border_match.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom::near_regular {

namespace {

/// Sums of one channel, relative to its mean, over the border of every patch.
class BorderSums {
public:
    BorderSums(const PlaneView& plane, double mean, bool squared)
        : m_stride(static_cast<std::size_t>(plane.width) + 1) {
        m_table.assign(m_stride * (static_cast<std::size_t>(plane.height) + 1), 0.0);
        for (int y = 0; y < plane.height; ++y) {
            double row = 0;
            for (int x = 0; x < plane.width; ++x) {
                const double value = static_cast<double>(plane(x, y)) - mean;
                row += squared ? value * value : value;
                const std::size_t at =
                    (static_cast<std::size_t>(y) + 1) * m_stride + static_cast<std::size_t>(x) + 1;
                m_table[at] = m_table[at - m_stride] + row;
            }
        }
    }

    double at(int x, int y, const Overlap& border, int patch) const {
        return over(x, y, patch, patch) - over(x + border.left, y + border.top,
                                               patch - border.left - border.right,
                                               patch - border.top - border.bottom);
    }

private:
    double over(int x, int y, int width, int height) const {
        const std::size_t top = static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x);
        const std::size_t bottom = top + static_cast<std::size_t>(height) * m_stride;
        const auto right = static_cast<std::size_t>(width);
        return m_table[bottom + right] - m_table[bottom] - m_table[top + right] + m_table[top];
    }

    std::size_t m_stride;
    std::vector<double> m_table;
};

} // namespace

BorderMatch::BorderMatch(const ImageView& exemplar, const PlaneView& mask, int patch, Match match)
    : m_exemplar(exemplar), m_patch(patch), m_match(match), m_means(channelMeans(exemplar)),
      m_distances(exemplar, mask, m_means, patch) {}

void BorderMatch::prepare(const Overlap& border) {
    m_distances.prepare(border);
    const auto known = [&](const Sums& sums) { return sums.border == border; };
    if (m_match == Match::Difference || std::any_of(m_sums.begin(), m_sums.end(), known))
        return;
    const Size positions = m_distances.positions();
    Sums sums{border, {}, {}, Image(positions, 1), 0};
    sums.count = double(m_patch) * m_patch -
                 double(m_patch - border.left - border.right) * (m_patch - border.top - border.bottom);
    for (int c = 0; c < m_exemplar.channels; ++c) {
        const double mean = m_means[static_cast<std::size_t>(c)];
        const BorderSums values(m_exemplar.plane(c), mean, false), squares(m_exemplar.plane(c), mean, true);
        Image& value = sums.values.emplace_back(positions, 1);
        Image& spread = sums.spreads.emplace_back(positions, 1);
        for (int y = 0; y < positions.height; ++y)
            for (int x = 0; x < positions.width; ++x) {
                const double s = values.at(x, y, border, m_patch), q = squares.at(x, y, border, m_patch);
                value(x, y, 0) = static_cast<float>(s);
                spread(x, y, 0) = static_cast<float>(std::sqrt(std::max(0.0, sums.count * q - s * s)));
                sums.squares(x, y, 0) += static_cast<float>(q);
            }
    }
    m_sums.push_back(std::move(sums));
}

/// Puts 1 − γ in place of the distances, from which it follows: Σ f g = (Σ f² + Σ g² − D) / 2.
void BorderMatch::toCorrelation(const ImageView& known, const Overlap& border, Scratch& scratch) const {
    const Sums& sums =
        *std::find_if(m_sums.begin(), m_sums.end(), [&](const Sums& s) { return s.border == border; });
    const auto channels = static_cast<std::size_t>(m_exemplar.channels);
    std::vector<double> values(channels), squares(channels), spreads(channels);
    double norm = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        for (int y = 0; y < m_patch; ++y)
            for (int x = 0; x < m_patch; ++x)
                if (border.contains(x, y, m_patch)) {
                    const double value = static_cast<double>(known(x, y, static_cast<int>(c))) - m_means[c];
                    values[c] += value;
                    squares[c] += value * value;
                }
        spreads[c] = std::sqrt(std::max(0.0, sums.count * squares[c] - values[c] * values[c]));
        norm += squares[c];
    }
    const Size positions = m_distances.positions();
    for (int y = 0; y < positions.height; ++y) {
        float* row =
            scratch.distances.data() + (m_distances.distanceRow(scratch, y) - scratch.distances.data());
        for (int x = 0; x < positions.width; ++x) {
            if (!m_distances.allows(x, y))
                continue; // stays infinite
            const double products =
                0.5 * (norm + static_cast<double>(sums.squares(x, y, 0)) - static_cast<double>(row[x]));
            double above = sums.count * products, below = 0;
            for (std::size_t c = 0; c < channels; ++c) {
                above -= values[c] * static_cast<double>(sums.values[c](x, y, 0));
                below += spreads[c] * static_cast<double>(sums.spreads[c](x, y, 0));
            }
            row[x] = below > 0 ? static_cast<float>(1 - above / below) : 1.0F;
        }
    }
}

Point BorderMatch::choose(const ImageView& known, const Overlap& border, const std::vector<Point>& points,
                          int tolerance, Scratch& scratch, const std::function<void()>& check) const {
    m_distances.compute(known, border, -std::numeric_limits<float>::infinity(), scratch, check);
    if (m_match == Match::Correlation)
        toCorrelation(known, border, scratch);
    Point best;
    float least = std::numeric_limits<float>::infinity();
    const Size positions = m_distances.positions();
    const auto scan = [&](int left, int top, int right, int bottom) {
        for (int y = std::max(0, top); y <= std::min(bottom, positions.height - 1); ++y) {
            const float* row = m_distances.distanceRow(scratch, y);
            for (int x = std::max(0, left); x <= std::min(right, positions.width - 1); ++x)
                if (row[x] < least) {
                    least = row[x];
                    best = {x, y};
                }
        }
    };
    for (const Point& p : points)
        scan(p.x - tolerance, p.y - tolerance, p.x + tolerance, p.y + tolerance);
    if (points.empty())
        scan(0, 0, positions.width, positions.height);
    return best;
}

std::uint64_t BorderMatch::bytesFor(Size exemplar, int channels, int shapes, Match match) {
    const auto images =
        match == Match::Correlation ? static_cast<std::uint64_t>(shapes * (2 * channels + 1)) : 0;
    return PatchDistances::bytesFor(exemplar, channels, 1, shapes) + images * Image::bytesFor(exemplar, 1) +
           2 * sizeof(double) * static_cast<std::uint64_t>(exemplar.area());
}

} // namespace texloom::near_regular
