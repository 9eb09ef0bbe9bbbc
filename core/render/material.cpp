#include "core/render/material.h"

#include "core/base/at.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

const Image* mapOf(const Material& material, MapRole role) {
    const auto found = material.maps.find(role);
    return found == material.maps.end() ? nullptr : found->second.get();
}

/// The size of all maps.
Size sizeOf(const Material& material) {
    const Image* first = nullptr;
    for (const auto& [role, map] : material.maps) {
        if (role == MapRole::Other || !map)
            continue;
        if (first && map->size() != first->size())
            failUsage("The maps of the material have {} × {} and {} × {} px, so that they do not lie on one "
                      "another; "
                      "choose maps of one size.",
                      first->width(), first->height(), map->width(), map->height());
        first = map.get();
    }
    return first ? first->size() : Size{1, 1};
}

void checkChannels(const Image& map, MapRole role) {
    constexpr int kVector = 3;
    if (isNormal(role) && map.channels() < kVector)
        failUsage(
            "A normal map needs 3 channels, and this one has {}; choose another map, or say what it holds.",
            map.channels());
}

/// One value of a map that holds one a pixel, or what holds without a map.
class Value {
public:
    Value(const Image* map, float otherwise) : m_map(map), m_otherwise(otherwise) {}
    float at(int x, int y) const { return m_map ? std::clamp((*m_map)(x, y, 0), 0.0F, 1.0F) : m_otherwise; }

private:
    const Image* m_map;
    float m_otherwise;
};

/// A normal along u, v and outwards, as the two kinds of maps have it.
std::array<float, 3> normalAt(const Image* map, bool greenDown, int x, int y) {
    if (!map)
        return {0, 0, 1};
    const float green = 2 * (*map)(x, y, 1) - 1;
    return {2 * (*map)(x, y, 0) - 1, greenDown ? green : -green, 2 * (*map)(x, y, 2) - 1};
}

/// Where a repeating coordinate lies among `count` pixels: the one before it, and how far it is from there.
struct Between {
    int first, second;
    float share;
};
Between between(float place, int count) {
    const float at = (place - std::floor(place)) * static_cast<float>(count) - 0.5F;
    const float below = std::floor(at);
    const int first = (static_cast<int>(below) + count) % count;
    return {first, (first + 1) % count, at - below};
}

} // namespace

MaterialTexture::MaterialTexture(const Material& material) {
    const Size size = sizeOf(material);
    for (const auto& [role, map] : material.maps)
        if (map)
            checkChannels(*map, role);
    const Image* colour = mapOf(material, MapRole::Color);
    const bool greenDown = mapOf(material, MapRole::NormalDx) != nullptr;
    const Image* normals = mapOf(material, greenDown ? MapRole::NormalDx : MapRole::NormalGl);
    const Value roughness(mapOf(material, MapRole::Roughness), material.roughness);
    const Value metallic(mapOf(material, MapRole::Metallic), material.metallic);
    const Value occlusion(mapOf(material, MapRole::Occlusion), 1);
    const Value height(mapOf(material, MapRole::Height), 1);
    const Value opacity(mapOf(material, MapRole::Opacity), 1);
    m_hasHeight = mapOf(material, MapRole::Height) != nullptr;
    Level& finest =
        m_levels.emplace_back(Level{size, std::vector<Sample>(static_cast<std::size_t>(size.area()))});
    const int last = colour && colour->channels() >= 3 ? 2 : 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            Sample& pixel = finest.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                          static_cast<std::size_t>(x)];
            for (int c = 0; c < 3; ++c)
                pixel[at(Red + c)] = colour ? std::max((*colour)(x, y, std::min(c, last)), 0.0F) : 0.5F;
            const std::array<float, 3> normal = normalAt(normals, greenDown, x, y);
            std::copy(normal.begin(), normal.end(), pixel.begin() + NormalU);
            pixel[Roughness] = roughness.at(x, y);
            pixel[Metallic] = metallic.at(x, y);
            pixel[Occlusion] = occlusion.at(x, y);
            pixel[Height] = height.at(x, y);
            pixel[Opacity] = opacity.at(x, y);
        }
    while (m_levels.back().size.longerSide() > 1) {
        const Level& from = m_levels.back();
        Level to{{std::max(1, from.size.width / 2), std::max(1, from.size.height / 2)}, {}};
        for (int y = 0; y < to.size.height; ++y)
            for (int x = 0; x < to.size.width; ++x) {
                Sample mean{};
                for (const int row : {2 * y, 2 * y + 1})
                    for (const int column : {2 * x, 2 * x + 1}) {
                        const Sample& pixel = from.pixels[static_cast<std::size_t>(row % from.size.height) *
                                                              static_cast<std::size_t>(from.size.width) +
                                                          static_cast<std::size_t>(column % from.size.width)];
                        for (std::size_t i = 0; i < Places; ++i)
                            mean[i] += pixel[i] / 4;
                    }
                to.pixels.push_back(mean);
            }
        m_levels.push_back(std::move(to));
    }
}

MaterialTexture::Corners MaterialTexture::around(const Level& level, float u, float v) {
    const Between x = between(u, level.size.width), y = between(v, level.size.height);
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(level.size.width) +
               static_cast<std::size_t>(column);
    };
    return {
        {at(x.first, y.first), at(x.second, y.first), at(x.first, y.second), at(x.second, y.second)},
        {(1 - x.share) * (1 - y.share), x.share * (1 - y.share), (1 - x.share) * y.share, x.share * y.share}};
}

float MaterialTexture::levelFor(float extent) const {
    const float pixels = extent * static_cast<float>(size().longerSide());
    return std::clamp(std::log2(std::max(pixels, 1.0F)), 0.0F, static_cast<float>(m_levels.size() - 1));
}

MaterialTexture::Sample MaterialTexture::sample(float u, float v, float extent) const {
    const float level = levelFor(extent);
    const auto lower = static_cast<std::size_t>(level);
    const float upperShare = level - static_cast<float>(lower);
    Sample sum{};
    const auto add = [&](const Level& from, float share) {
        const Corners corners = around(from, u, v);
        for (std::size_t k = 0; k < 4; ++k) {
            const Sample& pixel = from.pixels[corners.at[k]];
            const float weight = share * corners.share[k];
            for (std::size_t i = 0; i < Places; ++i)
                sum[i] += weight * pixel[i];
        }
    };
    add(m_levels[lower], 1 - upperShare);
    if (upperShare > 0)
        add(m_levels[lower + 1], upperShare);
    return sum;
}

float MaterialTexture::height(float u, float v, float extent) const {
    const Level& level = m_levels[static_cast<std::size_t>(levelFor(extent))];
    const Corners corners = around(level, u, v);
    float sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
        sum += corners.share[k] * level.pixels[corners.at[k]][Height];
    return sum;
}

} // namespace texloom
