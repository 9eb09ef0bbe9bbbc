#pragma once

#include "core/job/job_context.h"
#include "core/math/grid_flow.h"
#include "core/methods/near_regular/border_match.h"
#include "core/methods/near_regular/filler.h"
#include "core/methods/near_regular/phase_deviation.h"
#include "core/methods/near_regular/settings.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <vector>

namespace texloom::near_regular {

/// Whole tiles stitched one after another along the lattice (Liu, Tsin & Lin, IJCV 62, 2005; López Recas
/// 2011, fig. 2.8): upright rectangles that hold a tile and an overlap, by turns at lattice points and half a
/// period off both vectors. Each is the one of the exemplar's that fits best what is there, or nearly so,
/// moved by a few pixels to where it correlates best, and joined along a minimum cut. Beyond the sources, the
/// middles of tiles at lattice points lie within elements of the texture rather than across their joints, and
/// cuts keep to places at which the exemplar's tiles are alike: the joints between bricks of different tones.
class TileStitcher {
public:
    /// @param plan its block is the length of tiles along a direction in which everything repeats.
    /// @throws UsageError if the exemplar has no whole tile
    TileStitcher(const Request& request, const Settings& settings, const Plan& plan, JobContext& context);

    /// Fills image and map of the result: of the whole output, of which the part asked for is kept. In one
    /// stage of weight `weight`.
    void fill(Synthesis& result, double weight);

    /// Upper bound of the memory that it takes beside the plan.
    static std::uint64_t bytesFor(Size output, Size exemplar, int channels);

private:
    /// A place of the output for a tile: the top left of its rectangle, and what its draws are keyed by.
    struct Place {
        int x = 0, y = 0;
        int column = 0, row = 0; ///< twice the multiples of the lattice vectors
        Vec2 corner;             ///< of the tile itself
    };
    /// A pixel of the rectangle under way.
    struct Pixel {
        int x = 0, y = 0;    ///< in the output
        bool inside = false; ///< of the output, and not twice in the rectangle
        bool known = false;
        int node = -1;
    };

    void shapeTiles();
    void anchorTiles();
    std::vector<Place> places() const;
    void addPlace(std::vector<Place>& all, int column, int row) const;
    std::vector<Point> candidates(const Place& place) const;
    std::vector<Point> onLattice(Vec2 target) const;
    Point nearestAllowed(Vec2 target) const;
    void allowWhole();
    bool allows(int x, int y) const;
    void collect(const Place& place);
    bool settle(int& x, int& y) const;
    double error(Point patch) const;
    double correlation(Point patch) const;
    Point chosen(const Place& place);
    Point registered(Point patch) const;
    std::int32_t cost(const Pixel& pixel, int u, int v, Point patch) const;
    GridFlow graph(const Place& place, Point patch) const;
    void tie(const Place& place, int u, int v, GridFlow& flow) const;
    void paste(const Place& place, Point patch);
    std::size_t indexOf(int u, int v) const {
        return static_cast<std::size_t>(v) * static_cast<std::size_t>(m_tile.width) +
               static_cast<std::size_t>(u);
    }
    const Pixel* at(int u, int v) const;

    const Request& m_request;
    const Settings& m_settings;
    const Plan& m_plan;
    JobContext& m_context;
    Lattice m_shape; ///< of the tiles
    Vec2 m_least;    ///< of a tile's bounding box, from its corner
    int m_overlap = 0;
    Size m_tile;                        ///< the rectangle's
    Size m_positions;                   ///< of its top left in the exemplar
    std::vector<std::uint8_t> m_hidden; ///< by position, where the mask is in the way; empty without one
    double m_scale = 1;                 ///< from differences to capacities
    PhaseDeviation m_deviation;         ///< of the exemplar
    Vec2 m_anchor;                      ///< of the corner of tile (0, 0), in the output
    Image m_image;
    PositionMap m_map;
    std::vector<std::uint8_t> m_known; ///< by pixel of the output
    std::vector<Pixel> m_pixels;       ///< of the rectangle under way, by rows
    std::vector<Point> m_overlapped;   ///< those of it that are known, in the rectangle
};

} // namespace texloom::near_regular
