#pragma once

#include "core/job/job_context.h"
#include "core/match/masked_distances.h"
#include "core/match/patch_search.h"
#include "core/methods/seam_cost.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/corner_tiles.h"
#include "core/methods/wang_tiles/tile_set.h"

#include <cstdint>
#include <vector>

namespace texloom::wang_tiles {

/// Covers the inside of tiles with fresh patches of the exemplars, a different one for each tile (Ng et al.
/// 2005), cut out where they differ least from the tile's border (Kwatra et al. 2003). The pixels at the very
/// edges of tiles stay.
class Interiors {
public:
    Interiors(const Request& request, const Settings& settings, JobContext& context);

    /// Finds, for every tile of a set of full size, the place that fits its border best, away from those of
    /// other tiles and from where the samples at its corners go on.
    void find(const CornerTiles& border, const std::vector<Colours>& tiles);
    /// The tiles of a set of any size with these patches inside.
    TileSet cover(const CornerTiles& border, const std::vector<Colours>& tiles) const;

    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);

private:
    /// A tile whose inside is covered, and the cost of the seams.
    struct Covered {
        std::vector<Source> sources;
        std::int64_t cost = 0;
    };
    Covered covered(const CornerTiles& border, const Colours& colours, const PatchPosition& patch) const;
    std::vector<PatchPosition> bestPlaces(const CornerTiles& border, const Colours& colours,
                                          std::size_t exemplar,
                                          const std::vector<PatchPosition>& avoided) const;
    std::vector<PatchPosition> continued(const CornerTiles& border, const Colours& colours) const;
    std::size_t drawnExemplar(int tile) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    graph_cut::SeamCost m_cost;
    std::vector<MaskedDistances> m_distances; ///< by exemplar
    std::vector<PatchPosition> m_places;      ///< by tile
};

} // namespace texloom::wang_tiles
