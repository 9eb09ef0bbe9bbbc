#pragma once

#include "core/job/job_context.h"
#include "core/match/boundary_cut.h"
#include "core/match/patch_distances.h"
#include "core/methods/quilting/grid.h"
#include "core/methods/quilting/settings.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace texloom::quilting {

/// Synthesises one output patch by patch (Raad & Galerne, IPOL 2017, algorithms 1 to 4). Every exemplar patch
/// that the masks allow is a candidate for every output patch. With an initial image the whole patch is
/// compared with what is there, not the overlap alone (Raad, thesis 2016, section 5.4.2).
class Quilter {
public:
    Quilter(const Request& request, const Settings& settings, JobContext& context);
    ~Quilter();
    Quilter(const Quilter&) = delete;
    Quilter& operator=(const Quilter&) = delete;

    /// Runs to the end, as a wavefront over the context's threads or one patch after another in raster order:
    /// both give the same bits.
    enum class Order { Wavefront, Raster };
    Synthesis run(Order order = Order::Wavefront);

private:
    struct Workspace;
    struct Candidate {
        int exemplar = 0, x = 0, y = 0;
    };

    void prepareExemplars();
    void startFromInitial();
    void place(int index);
    Footprint compared(const Cell& cell) const;
    void readPatch(const Cell& cell, Image& patch) const;
    Candidate choose(const Cell& cell, Workspace& work) const;
    Candidate firstPatch(const Cell& cell) const;
    Candidate drawn(const Cell& cell, const Workspace& work) const;
    void measureError(const Cell& cell, const Candidate& source, Workspace& work) const;
    void weigh(const Cell& cell, const BoundaryCut& cut, Workspace& work) const;
    void stitch(const Cell& cell, const Candidate& source, const Workspace& work);

    std::unique_ptr<Workspace> borrow();
    void giveBack(std::unique_ptr<Workspace> work);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    Axis m_horizontal, m_vertical;
    Grid m_grid;
    float m_smallest; ///< distances below it count as it
    std::vector<PatchDistances> m_distances;
    Image m_canvas;
    PositionMap m_map;
    std::vector<double> m_cutCosts; ///< by cell, so that sums do not depend on the order
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Workspace>> m_idle;
};

} // namespace texloom::quilting
