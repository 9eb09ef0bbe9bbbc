#pragma once

#include "core/analysis/lattice.h"
#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/methods/regular_tile/settings.h"
#include "core/methods/regular_tile/tile_search.h"

#include <cstdint>
#include <vector>

namespace texloom::regular_tile {

/// What the whole tiles of an exemplar have in common and how they differ: their mean and their principal
/// components (Liu, Lin & Hays, SIGGRAPH 2004, section on colour; López Recas 2011, fig. 2.9). A tile is the
/// parallelogram of a lattice and a margin around it, in which neighbours fade into each other.
class TileFamily {
public:
    /// The tiles lie at `corner` and the multiples of the vectors of `from` away from it, resampled to its
    /// pixels; their shape is that of `shape`, which differs from `from` where an output wraps. Beyond the
    /// exemplar margins are mirrored. At most kMostTiles of them count, spread evenly.
    /// @param mask one channel of the exemplar's size or {}: tiles with a pixel where it is 0 do not count.
    /// @param margin in pixels. @param bases at most so many components, and as many as the tiles have.
    TileFamily(const ImageView& exemplar, const PlaneView& mask, const Lattice& from, const Lattice& shape,
               const Tile& corner, int margin, int bases, JobContext& context);

    static constexpr int kMostTiles = 256;

    int tiles() const { return m_tiles; }
    int bases() const { return static_cast<int>(m_variances.size()); }
    /// Of each component over the tiles, from the largest.
    const std::vector<double>& variances() const { return m_variances; }
    /// The share of the tiles' variance that the components have.
    double share() const { return m_share; }
    /// How much of each component is in tile `index`.
    std::vector<float> coefficients(int index) const;
    /// A new tile's: normal with the components' variances, or each of a tile drawn for it alone.
    /// @param a, b the tile's place by multiples of the lattice vectors
    std::vector<float> drawn(Draw draw, int a, int b, const Random& random) const;

    /// Pixel (dx, dy) from a tile's corner, within the margin; adds the channels, times `weight`, to `to`.
    void add(const std::vector<float>& coefficients, int dx, int dy, float weight, float* to) const;
    /// Whether that pixel is in the tile or its margin.
    bool has(int dx, int dy) const {
        return dx >= m_box.x && dy >= m_box.y && dx < m_box.right() && dy < m_box.bottom() && at(dx, dy) >= 0;
    }
    /// The mean, and to its right the components, added to it twice their deviation above and subtracted
    /// below.
    Image picture() const;

    /// Upper bound of the memory that it takes.
    static std::uint64_t bytesFor(Size exemplar, int channels);

private:
    using Corners = std::vector<Vec2>;

    int at(int dx, int dy) const {
        return m_number[static_cast<std::size_t>(dy - m_box.y) * static_cast<std::size_t>(m_box.size.width) +
                        static_cast<std::size_t>(dx - m_box.x)];
    }
    void numberPixels(const Lattice& shape, int margin);
    Corners wholeTiles(const ImageView& exemplar, const PlaneView& mask, const Lattice& from,
                       const Lattice& shape, Vec2 corner) const;
    std::vector<float> sampled(const ImageView& exemplar, Vec2 corner) const;
    void analyse(std::vector<std::vector<float>> tiles, int bases, JobContext& context);

    int m_channels, m_tiles = 0;
    Region m_box;              ///< around the tile and its margin, from its corner
    std::vector<int> m_number; ///< of a pixel of the box, or −1 outside the margin
    int m_pixels = 0;
    std::vector<float> m_mean;         ///< pixels × channels
    std::vector<float> m_components;   ///< pixels × bases × channels
    std::vector<float> m_coefficients; ///< tiles × bases
    std::vector<double> m_variances;
    double m_share = 0;
};

} // namespace texloom::regular_tile
