#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/samples.h"
#include "core/methods/wang_tiles/tile_colours.h"

#include <vector>

namespace texloom::wang_tiles {

/// The borders of tiles whose corners have colours (Ng, Wen, Tan, Zhang & Kim, "Generating an ω-tile set for
/// texture synthesis", CGI 2005; Lagae & Dutré, "An alternative for Wang tiles", ACM TOG 25, 2006). For each
/// colour there is one sample of an exemplar with the corner in its middle, so that what meets there lies
/// side by side in the exemplar. Two samples meet half way along an edge, in a cut that runs across it and
/// that all tiles beside that edge have in common.
class CornerTiles {
public:
    /// Cuts the edges of all pairs of colours, on both axes. @param size of the tiles, at most Settings::tile
    /// on either side.
    CornerTiles(const Request& request, const Settings& settings, Samples samples, Size size,
                JobContext& context);

    const Size& size() const { return m_size; }
    /// How deep the border of a tile is, in pixels: what lies within is to be covered.
    int depth() const { return m_depth; }
    /// Where pixel (x, y) of a tile's border comes from. Within, samples meet along cuts that go straight on.
    Source source(const Colours& colours, int x, int y) const;
    /// The mean error along the worst cut.
    double worstError() const { return m_worstError; }
    const Samples& samples() const { return m_samples; }

private:
    /// For each line beside an edge, from depth before it to depth after it, the first pixel of the second
    /// sample, counted along the edge.
    struct Cut {
        std::vector<int> first;
        double error = 0;
    };
    Cut cut(int one, int two, bool across) const;
    Source sampled(int colour, int dx, int dy) const;
    Source beside(int one, int two, bool across, int along, int away) const;
    std::size_t indexOf(int one, int two, bool across) const;

    const Request& m_request;
    int m_colours, m_reach, m_zone, m_depth;
    Samples m_samples;
    Size m_size;
    std::vector<Cut> m_cuts; ///< by pair of colours, of edges that run across and upright
    double m_worstError = 0;
};

} // namespace texloom::wang_tiles
