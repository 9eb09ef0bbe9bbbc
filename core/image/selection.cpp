#include "core/image/selection.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace texloom::selections {

namespace {

/// The smallest region with all pixels that are selected to `least` or more; empty if none is.
Region boundsOf(const ImageView& selection, float least) {
    int left = selection.width, top = selection.height, right = 0, bottom = 0;
    for (int y = 0; y < selection.height; ++y) {
        const float* const row = selection.plane(0).row(y);
        const float* const end = row + selection.width;
        const auto chosen = [least](float value) { return value >= least; };
        const float* const first = std::find_if(row, end, chosen);
        if (first == end)
            continue;
        int last = selection.width - 1;
        while (!chosen(row[last]))
            --last;
        left = std::min(left, static_cast<int>(first - row));
        right = std::max(right, last + 1);
        top = std::min(top, y);
        bottom = y + 1;
    }
    return right == 0 ? Region{} : Region{left, top, {right - left, bottom - top}};
}

/// A region with so many pixels more on each side, as far as they lie in the picture.
Region widened(const Region& region, int pixels, Size whole) {
    const int left = std::max(0, region.x - pixels), top = std::max(0, region.y - pixels);
    return {left,
            top,
            {std::min(whole.width, region.right() + pixels) - left,
             std::min(whole.height, region.bottom() + pixels) - top}};
}

/// Half the width of a disc at this height over its middle.
int halfWidth(int radius, int height) {
    return static_cast<int>(std::sqrt(static_cast<double>(radius) * radius - height * height));
}

/// The largest values in stretches of a row: those of 2^k pixels are kept, and two of them cover any other.
class RowMaxima {
public:
    RowMaxima(int width, int radius)
        : m_width(width), m_radius(radius),
          m_levels(static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(2 * radius + 1))),
                   std::vector<float>(static_cast<std::size_t>(width + 2 * radius))) {}

    void take(const float* row) {
        std::copy_n(row, m_width, m_levels.front().begin() + m_radius);
        for (std::size_t k = 1; k < m_levels.size(); ++k) {
            const std::vector<float>& half = m_levels[k - 1];
            const std::size_t step = std::size_t{1} << (k - 1);
            for (std::size_t i = 0; i + 2 * step <= half.size(); ++i)
                m_levels[k][i] = std::max(half[i], half[i + step]);
        }
    }

    /// Raises each value to the largest of those up to `half` beside its place.
    void raise(float* values, int half) const {
        const auto length = static_cast<unsigned>(2 * half + 1);
        const int level = std::bit_width(length) - 1;
        const float* const first = m_levels[static_cast<std::size_t>(level)].data() + m_radius - half;
        const float* const second = first + static_cast<int>(length) - (1 << level);
        for (int x = 0; x < m_width; ++x)
            values[x] = std::max(values[x], std::max(first[x], second[x]));
    }

private:
    int m_width;
    int m_radius;
    std::vector<std::vector<float>> m_levels;
};

/// How far the nearest pixel that is wholly selected lies in the same row; `most` if that is nearer.
void distancesInRow(const float* row, int width, int most, int* distances) {
    int away = most;
    for (int x = 0; x < width; ++x) {
        away = row[x] >= 1 ? 0 : std::min(away + 1, most);
        distances[x] = away;
    }
    away = most;
    for (int x = width - 1; x >= 0; --x) {
        away = row[x] >= 1 ? 0 : std::min(away + 1, most);
        distances[x] = std::min(distances[x], away);
    }
}

/// Where the sides of a polygon cross a line, and whether they go down or up there.
std::vector<std::pair<double, int>> crossingsOf(const PlanePoints& corners, double y) {
    std::vector<std::pair<double, int>> crossings;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PlanePoint& from = corners[i];
        const PlanePoint& to = corners[(i + 1) % corners.size()];
        if ((from.y <= y) != (to.y <= y))
            crossings.emplace_back(from.x + (y - from.y) * (to.x - from.x) / (to.y - from.y),
                                   from.y <= y ? 1 : -1);
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

/// The first pixel whose middle is not left of x, within 0 and width.
int pixelFrom(double x, int width) {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width)));
}

} // namespace

Image polygon(Size size, const PlanePoints& corners) {
    Image shape(size, 1);
    for (int y = 0; y < size.height; ++y) {
        int winding = 0;
        double from = 0;
        for (const auto& [x, way] : crossingsOf(corners, y + 0.5)) {
            if (winding != 0) {
                const int first = pixelFrom(from, size.width);
                std::fill_n(shape.plane(0).row(y) + first, pixelFrom(x, size.width) - first, 1.0F);
            }
            winding += way;
            from = x;
        }
    }
    return shape;
}

Image combined(const ImageView& selection, const ImageView& shape, bool add) {
    Image made(selection);
    for (int y = 0; y < made.height(); ++y) {
        float* const row = made.plane(0).row(y);
        const float* const other = shape.plane(0).row(y);
        for (int x = 0; x < made.width(); ++x)
            row[x] = add ? std::max(row[x], other[x]) : std::min(row[x], 1 - other[x]);
    }
    return made;
}

Image inverted(const ImageView& selection) {
    Image made(selection);
    for (int y = 0; y < made.height(); ++y) {
        float* const row = made.plane(0).row(y);
        std::transform(row, row + made.width(), row, [](float value) { return 1 - value; });
    }
    return made;
}

Image grown(const ImageView& selection, int pixels, const std::function<void()>& check) {
    Image made(selection);
    const Region selected = boundsOf(selection, std::numeric_limits<float>::min());
    if (selected.size.empty() || pixels <= 0)
        return made;
    const Region reached = widened(selected, pixels, selection.size());
    RowMaxima maxima(reached.size.width, pixels);
    for (int from = selected.y; from < selected.bottom(); ++from) {
        check();
        maxima.take(selection.plane(0).row(from) + reached.x);
        const int top = std::max(reached.y, from - pixels),
                  bottom = std::min(reached.bottom(), from + pixels + 1);
        for (int y = top; y < bottom; ++y)
            maxima.raise(made.plane(0).row(y) + reached.x, halfWidth(pixels, y - from));
    }
    return made;
}

Image shrunk(const ImageView& selection, int pixels, const std::function<void()>& check) {
    Image made(selection);
    const Region selected = boundsOf(selection, std::numeric_limits<float>::min());
    if (selected.size.empty() || pixels <= 0)
        return made;
    // What is not selected grows into it; of all that lies around, the pixels beside it are the nearest.
    const Region part = widened(selected, 1, selection.size());
    const Image rest = grown(inverted(selection.crop(part.x, part.y, part.size)), pixels, check);
    for (int y = 0; y < part.size.height; ++y)
        for (int x = 0; x < part.size.width; ++x)
            made(part.x + x, part.y + y, 0) = 1 - rest(x, y, 0);
    return made;
}

Image feathered(const ImageView& selection, int pixels, const std::function<void()>& check) {
    Image made(selection);
    const Region selected = boundsOf(selection, 1);
    if (selected.size.empty() || pixels <= 0)
        return made;
    const Region reached = widened(selected, pixels, selection.size());
    const int width = reached.size.width, most = pixels + 1;
    std::vector<int> distances(static_cast<std::size_t>(reached.size.area()));
    const auto rowAt = [&](int y) {
        return distances.data() + static_cast<std::ptrdiff_t>(y - reached.y) * width;
    };
    for (int y = reached.y; y < reached.bottom(); ++y)
        distancesInRow(selection.plane(0).row(y) + reached.x, width, most, rowAt(y));
    std::vector<std::int64_t> nearest(static_cast<std::size_t>(width));
    for (int y = reached.y; y < reached.bottom(); ++y) {
        check();
        std::fill(nearest.begin(), nearest.end(), static_cast<std::int64_t>(most) * most);
        for (int from = std::max(reached.y, y - pixels); from < std::min(reached.bottom(), y + most); ++from)
            for (int x = 0; x < width; ++x) {
                const std::int64_t across = rowAt(from)[x], down = y - from;
                std::int64_t& best = nearest[static_cast<std::size_t>(x)];
                best = std::min(best, across * across + down * down);
            }
        float* const row = made.plane(0).row(y) + reached.x;
        for (int x = 0; x < width; ++x) {
            const double away = std::sqrt(static_cast<double>(nearest[static_cast<std::size_t>(x)]));
            row[x] = std::max(row[x], static_cast<float>(1 - away / most));
        }
    }
    return made;
}

} // namespace texloom::selections
