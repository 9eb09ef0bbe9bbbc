#include "core/analysis/map_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

using Color = std::array<float, 3>;

/// The colour of a hue, saturation and value, each 0 to 1.
Color colorOf(double hue, double saturation, double value) {
    Color color{};
    for (int c = 0; c < 3; ++c) {
        const double ramp = std::abs(std::fmod(hue * 6 + 6 - 2 * c, 6.0) - 3) - 1;
        color[static_cast<std::size_t>(c)] =
            static_cast<float>(value * (1 - saturation * (1 - std::clamp(ramp, 0.0, 1.0))));
    }
    return color;
}

/// Hue turns with the angle around the exemplar's centre; saturation grows outwards and lightness falls from
/// top to bottom, so that position and colour determine each other.
Color colorAt(double u, double v, int exemplar, int count) {
    const double angle = std::atan2(v - 0.5, u - 0.5) / (2 * std::numbers::pi) + 0.5;
    const double hue = (exemplar + angle * (count > 1 ? 0.8 : 1.0)) / count;
    const double radius = std::min(1.0, 2 * std::max(std::abs(u - 0.5), std::abs(v - 0.5)));
    const double saturation = 0.15 + 0.85 * std::sqrt(radius);
    const double value = 0.95 - 0.45 * v;
    return colorOf(hue, saturation, value);
}

/// A colour for everything that was copied with the same offset: any hue, neither dark nor pale.
Color colorOfOffset(int dx, int dy, int exemplar) {
    std::uint64_t mixed = static_cast<std::uint64_t>(dx + 65536) * 0x9e3779b97f4a7c15ULL +
                          static_cast<std::uint64_t>(dy + 65536) * 0xc2b2ae3d27d4eb4fULL +
                          static_cast<std::uint64_t>(exemplar) * 0x165667b19e3779f9ULL;
    mixed ^= mixed >> 29U;
    mixed *= 0xbf58476d1ce4e5b9ULL;
    mixed ^= mixed >> 32U;
    const auto part = [&](unsigned shift) { return static_cast<double>((mixed >> shift) & 255U) / 255; };
    const double hue = part(0), saturation = 0.45 + 0.4 * part(8), value = 0.45 + 0.5 * part(16);
    return colorOf(hue, saturation, value);
}

bool copiedTogether(const Source& a, const Source& b, int dx, int dy) {
    return a.exemplar == b.exemplar && b.x - a.x == dx && b.y - a.y == dy;
}

} // namespace

Image positionPicture(Size exemplarSize, int exemplar, int count) {
    Image picture(exemplarSize, 3);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const Color color =
                colorAt((x + 0.5) / exemplarSize.width, (y + 0.5) / exemplarSize.height, exemplar, count);
            for (int c = 0; c < 3; ++c)
                picture(x, y, c) = color[static_cast<std::size_t>(c)];
        }
    return picture;
}

Image synthesisPicture(const PositionMap& map) {
    const int count = static_cast<int>(map.exemplarSizes().size());
    std::vector<Image> pictures;
    for (int i = 0; i < count; ++i)
        pictures.push_back(positionPicture(map.exemplarSizes()[static_cast<std::size_t>(i)], i, count));
    const std::vector<ImageView> views(pictures.begin(), pictures.end());
    return map.apply(views);
}

Image copiedRegionsPicture(const PositionMap& map) {
    Image picture(map.size(), 3);
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            const Source& source = map.at(x, y);
            const bool border = (x > 0 && !copiedTogether(map.at(x - 1, y), source, 1, 0)) ||
                                (y > 0 && !copiedTogether(map.at(x, y - 1), source, 0, 1));
            if (!source.valid() || border)
                continue;
            const Color color = colorOfOffset(source.x - x, source.y - y, source.exemplar);
            for (int c = 0; c < 3; ++c)
                picture(x, y, c) = color[static_cast<std::size_t>(c)];
        }
    return picture;
}

double innovation(const PositionMap& map, const std::function<void()>& check) {
    std::int64_t pairs = 0;
    std::int64_t broken = 0;
    const auto count = [&](const Source& a, const Source& b, int dx, int dy) {
        ++pairs;
        broken += copiedTogether(a, b, dx, dy) ? 0 : 1;
    };
    for (int y = 0; y < map.height(); ++y) {
        check();
        for (int x = 0; x < map.width(); ++x) {
            if (x + 1 < map.width())
                count(map.at(x, y), map.at(x + 1, y), 1, 0);
            if (y + 1 < map.height())
                count(map.at(x, y), map.at(x, y + 1), 0, 1);
        }
    }
    return pairs == 0 ? 0 : static_cast<double>(broken) / static_cast<double>(pairs);
}

} // namespace texloom
