#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/match/patch_search.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/settings.h"

#include <cstdint>
#include <vector>

namespace texloom::wang_tiles {

/// Colours of a tile's edges: above, right, below, left.
struct Edges {
    int north = 0, east = 0, south = 0, west = 0;
    friend bool operator==(const Edges&, const Edges&) = default;
};

/// Pixels of a sample to either side of its edge: half a tile, half the zone of the cuts, and a little for
/// rounding.
int reachOf(const Settings& settings);
/// Side of a square that holds a sample of either axis.
int sampleSide(const Settings& settings);

/// The tiles of one set, all of one size (Cohen, Shade, Hiller & Deussen, SIGGRAPH 2003). For each colour of
/// each axis there is one sample of an exemplar with its edge in the middle; a tile joins the halves of four
/// of them along its two diagonals, where they differ least. So what meets at an edge lies side by side in
/// the exemplar. The pixels at the upper corners are of the sample above, those at the lower ones of the
/// samples beside.
class TileSet {
public:
    /// The samples of all colours, by the top left of the squares that hold them.
    struct Samples {
        std::vector<PatchPosition> across; ///< of edges that run across, above and below tiles
        std::vector<PatchPosition> upright;
    };

    /// Cuts every tile. @param size of the tiles, at most Settings::tile on either side.
    TileSet(const Request& request, const Settings& settings, Samples samples, Size size,
            const std::vector<Edges>& edges, JobContext& context);

    const Size& size() const { return m_size; }
    /// Where pixel (x, y) of a tile comes from.
    Source source(const Edges& edges, int x, int y) const;
    /// The mean error along the cuts of the worst tile.
    double worstError() const { return m_worstError; }

    static std::uint64_t bytesFor(const Settings& settings);

private:
    /// For each row of a tile the first pixel on the cut's far side: of the diagonal from the upper left as
    /// counted from the left, and of the other as counted from the right.
    struct Cuts {
        std::vector<int> falling, rising;
        double error = 0;
    };
    struct Path {
        std::vector<int> first;
        double cost = 0;
        int length = 0;
    };
    std::size_t indexOf(const Edges& edges) const;
    Source sampled(const Edges& edges, int part, int x, int y) const;
    double difference(const Source& a, const Source& b) const;
    Path cut(const Edges& edges, bool rising) const;

    const Request& m_request;
    int m_colours, m_reach;
    double m_zone; ///< half its width over the side
    Samples m_samples;
    Size m_size;
    std::vector<Cuts> m_cuts;
    double m_worstError = 0;
};

/// The edges of all tiles of a set. In a full one they are in the order in which they lie side by side on a
/// sheet, matching, colours² in a row (Wei, "Tile-based texture mapping on graphics hardware", 2004).
std::vector<Edges> edgesOf(const Settings& settings);

/// Place in a row of matching tiles of the one with these colours at its two ends (Wei 2004, eq. 2).
int sheetPlace(int first, int second);

} // namespace texloom::wang_tiles
