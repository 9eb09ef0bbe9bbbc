#include "core/methods/near_regular/preparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace texloom::near_regular {

namespace {

/// Means over `width` values along a line, fewer at its ends.
void boxBlur(std::vector<double>& line, int width) {
    const int count = static_cast<int>(line.size()), reach = width / 2;
    std::vector<double> sums(line.size() + 1, 0.0);
    for (int i = 0; i < count; ++i)
        sums[static_cast<std::size_t>(i) + 1] =
            sums[static_cast<std::size_t>(i)] + line[static_cast<std::size_t>(i)];
    for (int i = 0; i < count; ++i) {
        const int from = std::max(0, i - reach), to = std::min(count, i + reach + 1);
        line[static_cast<std::size_t>(i)] =
            (sums[static_cast<std::size_t>(to)] - sums[static_cast<std::size_t>(from)]) / (to - from);
    }
}

/// Two box filters in succession: a soft window that removes a period of its width completely.
void blur(PlaneSpan plane, int width, const std::function<void()>& check) {
    std::vector<double> line;
    for (int y = 0; y < plane.height; ++y) {
        check();
        line.assign(plane.row(y), plane.row(y) + plane.width);
        boxBlur(line, width);
        boxBlur(line, width);
        std::transform(line.begin(), line.end(), plane.row(y),
                       [](double v) { return static_cast<float>(v); });
    }
    for (int x = 0; x < plane.width; ++x) {
        check();
        line.clear();
        for (int y = 0; y < plane.height; ++y)
            line.push_back(static_cast<double>(plane(x, y)));
        boxBlur(line, width);
        boxBlur(line, width);
        for (int y = 0; y < plane.height; ++y)
            plane(x, y) = static_cast<float>(line[static_cast<std::size_t>(y)]);
    }
}

/// The shortest translation of the lattice within 20° of an axis, pointing right or down.
std::optional<Vec2> nearAxis(const Lattice& lattice, bool vertical) {
    const double steepest = std::tan(20 * std::acos(-1.0) / 180);
    std::optional<Vec2> best;
    for (int a = -3; a <= 3; ++a)
        for (int b = -3; b <= 3; ++b) {
            const Vec2 v = lattice.at(a, b);
            const double along = vertical ? v.y : v.x, aside = std::abs(vertical ? v.x : v.y);
            if (along > 0 && aside <= steepest * along && (!best || v.length() < best->length() - 1e-6))
                best = v;
        }
    return best;
}

/// The lengths of two translations once they are put on the axes: whole numbers of pixels, and equally many
/// for each of the lattice's own steps where the two are multiples of those.
Lattice onAxes(const Lattice& lattice, std::optional<Vec2> right, std::optional<Vec2> down) {
    const auto whole = [](double length, double parts) {
        return parts * std::max(1.0, std::round(length / parts));
    };
    if (right && down) {
        const double parts = std::max(1.0, std::round(std::abs(cross(*right, *down)) / lattice.area()));
        return {{whole(right->length(), parts), 0}, {0, whole(down->length(), parts)}};
    }
    return {{std::round(lattice.v1.x), std::round(lattice.v1.y)},
            {std::round(lattice.v2.x), std::round(lattice.v2.y)}};
}

/// Weights of the four samples round a point, `t` from the second.
std::array<double, 4> cubic(double t) {
    return {0.5 * t * (-1 + t * (2 - t)), 0.5 * (2 + t * t * (-5 + 3 * t)), 0.5 * t * (1 + t * (4 - 3 * t)),
            0.5 * t * t * (t - 1)};
}

} // namespace

Image flattened(const ImageView& exemplar, int width, const std::function<void()>& check) {
    Image light(exemplar);
    for (int c = 0; c < light.channels(); ++c)
        blur(light.plane(c), std::max(1, width), check);
    const std::vector<double> means = channelMeans(light);
    for (int c = 0; c < light.channels(); ++c)
        for (int y = 0; y < light.height(); ++y)
            for (int x = 0; x < light.width(); ++x)
                light(x, y, c) = exemplar(x, y, c) - light(x, y, c) +
                                 static_cast<float>(means[static_cast<std::size_t>(c)]);
    return light;
}

double unevenness(const ImageView& exemplar, int width, const std::function<void()>& check) {
    double worst = 0;
    for (int c = 0; c < exemplar.channels; ++c) {
        Image light(exemplar.channelRange(c, 1));
        blur(light.plane(0), std::max(1, width), check);
        const double mean = channelMeans(light).front();
        double slow = 0, rest = 0;
        for (int y = 0; y < light.height(); ++y)
            for (int x = 0; x < light.width(); ++x) {
                const auto here = static_cast<double>(light(x, y, 0));
                const double fast = static_cast<double>(exemplar(x, y, c)) - here;
                slow += (here - mean) * (here - mean);
                rest += fast * fast;
            }
        if (rest > 0)
            worst = std::max(worst, std::sqrt(slow / rest));
    }
    return worst;
}

Rectification rectification(const Lattice& lattice, Size exemplar) {
    const std::optional<Vec2> right = nearAxis(lattice, false), down = nearAxis(lattice, true);
    const Lattice from = right && down ? Lattice{*right, *down} : lattice;
    const Lattice to = onAxes(lattice, right, down);
    // The map takes `to` to `from`; its columns are the images of steps right and down.
    const auto lead = [&](Vec2 step) {
        const Vec2 c = to.coordinates(step);
        return from.at(c.x, c.y);
    };
    Rectification result;
    result.columnX = lead({1, 0});
    result.columnY = lead({0, 1});
    const Lattice change{result.columnX, result.columnY};
    result.lattice = {change.coordinates(lattice.v1), change.coordinates(lattice.v2)};
    // The axis-aligned rectangle inside the exemplar's image under the map.
    const double w = exemplar.width - 1, h = exemplar.height - 1;
    const Vec2 topRight = change.coordinates({w, 0}), bottomLeft = change.coordinates({0, h});
    const Vec2 bottomRight = change.coordinates({w, h});
    const double x0 = std::max(0.0, bottomLeft.x), x1 = std::min(topRight.x, bottomRight.x);
    const double y0 = std::max(0.0, topRight.y), y1 = std::min(bottomLeft.y, bottomRight.y);
    result.origin = x0 * result.columnX + y0 * result.columnY;
    result.size = {static_cast<int>(std::floor(x1 - x0)) + 1, static_cast<int>(std::floor(y1 - y0)) + 1};
    if (result.size.width < exemplar.width / 3 || result.size.height < exemplar.height / 3)
        result.size = {};
    return result;
}

Image rectified(const ImageView& exemplar, const Rectification& by, const std::function<void()>& check) {
    Image image(by.size, exemplar.channels);
    const auto column = [&](int x) { return std::clamp(x, 0, exemplar.width - 1); };
    const auto row = [&](int y) { return std::clamp(y, 0, exemplar.height - 1); };
    for (int y = 0; y < image.height(); ++y) {
        check();
        for (int x = 0; x < image.width(); ++x) {
            const Vec2 at = by.from(x, y);
            const int left = static_cast<int>(std::floor(at.x)) - 1,
                      top = static_cast<int>(std::floor(at.y)) - 1;
            const auto across = cubic(at.x - left - 1), down = cubic(at.y - top - 1);
            for (int c = 0; c < image.channels(); ++c) {
                double sum = 0;
                for (int j = 0; j < 4; ++j)
                    for (int i = 0; i < 4; ++i)
                        sum += down[static_cast<std::size_t>(j)] * across[static_cast<std::size_t>(i)] *
                               static_cast<double>(exemplar(column(left + i), row(top + j), c));
                image(x, y, c) = static_cast<float>(sum);
            }
        }
    }
    return image;
}

} // namespace texloom::near_regular
