#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/patch_canvas.h"
#include "core/match/patch_search.h"
#include "core/methods/quilting/settings.h"
#include "core/methods/synthesis.h"

#include <vector>

namespace texloom::quilting {

/// Synthesises one output patch by patch (Raad & Galerne, IPOL 2017, algorithms 1 to 4). Every exemplar patch
/// that the masks allow is a candidate for every output patch. With an initial image the whole patch is
/// compared with what is there, not the overlap alone (Raad, thesis 2016, section 5.4.2).
class Quilter {
public:
    Quilter(const Request& request, const Settings& settings, JobContext& context);

    /// Runs to the end, as a wavefront over the context's threads or one patch after another in raster order:
    /// both give the same bits.
    enum class Order { Wavefront, Raster };
    Synthesis run(Order order = Order::Wavefront);

private:
    /// What one thread needs to place a patch.
    struct Workspace {
        Image known;  ///< the patch as it is on the canvas
        Image error;  ///< squared differences to the chosen patch, where they overlap
        Image weight; ///< share of the old pixel, 0 to 1
        PatchSearch::Scratch scratch;
    };

    void prepareExemplars();
    void place(int index);
    Footprint compared(const PatchCell& cell) const;
    PatchPosition choose(const PatchCell& cell, Workspace& work) const;
    void trace(const PatchCell& cell, const PatchPosition& source, const PlaneView& weight);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    PatchSearch m_search;
    PatchCanvas m_canvas;
    PositionMap m_map;
    std::vector<double> m_cutCosts; ///< by cell, so that sums do not depend on the order
    Pool<Workspace> m_pool;
};

} // namespace texloom::quilting
