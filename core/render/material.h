#pragma once

#include "core/image/image.h"
#include "core/image/map_role.h"

#include <array>
#include <map>
#include <memory>

namespace texloom {

/// The maps of a material, in register: what holds for one point of a surface.
struct Material {
    /// By what they hold; Color linear in the working space, the others as their files have them. Other is
    /// not looked at. A map of one channel holds its value, one of more its first channel, but for colours
    /// and normals.
    std::map<MapRole, std::shared_ptr<const Image>> maps;
    float roughness = 0.6F; ///< where there is no map of it
    float metallic = 0;     ///< likewise
};

/// A material as it is sampled: all maps side by side, and smaller and smaller ones for what is far away.
class MaterialTexture {
public:
    /// Where each value lies in a sample. Normals are along u, v and outwards, not normalised.
    enum Place {
        Red,
        Green,
        Blue,
        NormalU,
        NormalV,
        NormalOut,
        Roughness,
        Metallic,
        Occlusion,
        Height,
        Opacity,
        Places = 12
    };
    using Sample = std::array<float, Places>;

    /// @throws UsageError if maps have different sizes, naming both, or a colour or normal map too few
    /// channels.
    explicit MaterialTexture(const Material& material);

    Size size() const { return m_levels.front().size; }
    bool hasHeight() const { return m_hasHeight; }

    /// The material at a place; (0, 0) is the top left of the maps and (1, 1) the bottom right, from where on
    /// they repeat. @param extent what a pixel sees of it, as a share of the maps' side: larger sees
    /// smoother.
    Sample sample(float u, float v, float extent) const;
    /// Its height alone, from 0 to 1, at one level of detail.
    float height(float u, float v, float extent) const;

private:
    struct Level {
        Size size;
        std::vector<Sample> pixels;
    };
    /// The four pixels around a place, and their shares.
    struct Corners {
        std::array<std::size_t, 4> at;
        std::array<float, 4> share;
    };
    static Corners around(const Level& level, float u, float v);
    float levelFor(float extent) const;

    std::vector<Level> m_levels;
    bool m_hasHeight = false;
};

} // namespace texloom
