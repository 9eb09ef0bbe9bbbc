#pragma once

#include "core/job/job_context.h"
#include "core/match/pixel_canvas.h"
#include "core/match/scan_order.h"
#include "core/methods/jump_map/jump_lists.h"
#include "core/methods/jump_map/settings.h"
#include "core/methods/pixel_request.h"
#include "core/methods/synthesis.h"

#include <array>
#include <memory>

namespace texloom::jump_map {

/// Makes an output by walks through the exemplar: each pixel continues the walk of one of its known
/// neighbours, or jumps from there to a place that looks alike (Zelinka & Garland, "Towards real-time texture
/// synthesis with the jump map", EGWR 2002). Where the source chooses a neighbour by chance, the walk is
/// followed here whose last steps look most like what the neighbours show, which makes cleaner joins.
class Walker {
public:
    Walker(const Request& request, const Settings& settings, JobContext& context);
    Synthesis run(ScanOrder::Order order = ScanOrder::Order::Wavefront);

private:
    /// A known neighbour of the pixel that is made.
    struct Neighbour {
        int dx, dy;
        bool known = false;
        Source source = {};
        const float* pixel = nullptr;
    };
    static constexpr int kNeighbours = 8;
    using Neighbours = std::array<Neighbour, kNeighbours>;

    Neighbours around(int x, int y) const;
    Source step(int x, int y, bool closes) const;
    void scan(const ScanOrder& rows, bool closes, ScanOrder::Order order);
    Source restart(const Neighbours& near, int x, int y) const;
    Source jumped(const Source& source, int x, int y) const;
    float misfit(const Neighbours& near, const Source& source, float limit) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    PixelPyramid m_pyramid; ///< of one scale
    NeighbourhoodSet m_set;
    std::unique_ptr<JumpLists> m_lists;
    PixelCanvas m_canvas;
};

} // namespace texloom::jump_map
