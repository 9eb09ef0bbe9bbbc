#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/coherent_candidates.h"
#include "core/match/neighbourhood.h"
#include "core/match/scan_order.h"
#include "core/methods/ashikhmin/settings.h"
#include "core/methods/pixel_request.h"
#include "core/methods/synthesis.h"

#include <optional>
#include <vector>

namespace texloom::ashikhmin {

/// Makes an output in raster order, where each pixel continues one of the copies that its known neighbours
/// belong to: the one whose neighbourhood in the exemplar is nearest to the output's (Ashikhmin,
/// "Synthesizing natural textures", I3D 2001). So copied pieces grow until they meet. A target, an image of
/// the output's size, stands for what is not made yet: the exemplar then takes its shape.
class Synthesizer {
public:
    Synthesizer(const Request& request, const Settings& settings, JobContext& context);
    Synthesis run(ScanOrder::Order order = ScanOrder::Order::Wavefront);

private:
    struct Workspace {
        std::vector<float> wanted;
        std::vector<Continuation> coherent;
        std::vector<Source> candidates;
    };

    /// One time through some rows.
    struct Pass {
        std::uint32_t number = 0;
        /// Whether rows are mended that all else is made about: then what follows is compared, even if there
        /// is a target.
        bool closes = false;
        double begun = 0, share = 0; ///< of the stage
    };

    void drawSources();
    void scan(const Pass& pass, const ScanOrder& scan, ScanOrder::Order order);
    void collect(const Pass& pass, int x, int y, Workspace& work) const;
    Neighbourhood compared(const Pass& pass, const PixelRuns& causal, const PixelRuns& following,
                           const PixelRuns& targeted) const;
    Neighbourhood clipped(const Pass& pass, int x, int y) const;
    bool inside(int x, int y) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    int m_reach;
    PixelPyramid m_pyramid; ///< of one scale
    NeighbourhoodSet m_set; ///< where candidates may lie
    PixelCanvas m_canvas;
    std::optional<Interleaved> m_target;
    PixelRuns m_causal, m_following, m_around, m_targeted;
    Pool<Workspace> m_pool;
};

} // namespace texloom::ashikhmin
