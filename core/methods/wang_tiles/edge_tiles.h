#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/samples.h"
#include "core/methods/wang_tiles/tile_colours.h"

#include <cstdint>
#include <vector>

namespace texloom::wang_tiles {

/// The tiles of one set, all of one size (Cohen, Shade, Hiller & Deussen, SIGGRAPH 2003). For each colour of
/// each axis there is one sample of an exemplar with its edge in the middle; a tile joins the halves of four
/// of them along its two diagonals, where they differ least. So what meets at an edge lies side by side in
/// the exemplar. The pixels at the upper corners are of the sample above, those at the lower ones of the
/// samples beside.
class EdgeTiles {
public:
    /// Cuts every tile. @param size of the tiles, at most Settings::tile on either side.
    EdgeTiles(const Request& request, const Settings& settings, Samples samples, Size size,
              const std::vector<Colours>& tiles, JobContext& context);

    const Size& size() const { return m_size; }
    /// Where pixel (x, y) of a tile comes from.
    Source source(const Colours& colours, int x, int y) const;
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
    std::size_t indexOf(const Colours& colours) const;
    Source sampled(const Colours& colours, int part, int x, int y) const;
    Path cut(const Colours& colours, bool rising) const;

    const Request& m_request;
    int m_colours, m_reach;
    double m_zone; ///< half its width over the side
    Samples m_samples;
    Size m_size;
    std::vector<Cuts> m_cuts;
    double m_worstError = 0;
};

} // namespace texloom::wang_tiles
