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

    void drawSources();
    void scan(int pass, const ScanOrder& scan, double begun, double share, ScanOrder::Order order);
    void collect(int pass, int x, int y, Workspace& work) const;
    Neighbourhood compared(int pass, const PixelRuns& causal, const PixelRuns& following) const;
    Neighbourhood clipped(int pass, int x, int y) const;
    bool inside(int x, int y) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    int m_reach;
    PixelPyramid m_pyramid; ///< of one scale
    NeighbourhoodSet m_set; ///< where candidates may lie
    PixelCanvas m_canvas;
    std::optional<Interleaved> m_target;
    PixelRuns m_causal, m_following, m_targeted;
    Pool<Workspace> m_pool;
};

} // namespace texloom::ashikhmin
