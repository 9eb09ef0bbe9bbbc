#pragma once

#include "core/job/job_context.h"
#include "core/match/exemplar_pyramid.h"
#include "core/methods/fill_request.h"
#include "core/methods/fill_scales.h"
#include "core/methods/pixel_grower.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <vector>

namespace texloom::efros_leung {

using pixel_growth::Settings;

/// Makes what is not known of a picture pixel by pixel, from coarse to fine: each scale grows from the border
/// as a whole output grows from its seed, and sees the coarser scale's result where nothing is made yet. So a
/// pixel at the border joins what lies on the other side, where growth at one scale would meet itself in the
/// middle along a line. On every scale the seams between what is copied are moved, and at last its tone is
/// evened out. With one scale, seams where they are and tone as it is, this is Efros & Leung's growth.
class HoleGrower {
public:
    /// @param window of a request with what may be copied in the exemplars' masks: see withoutHole().
    HoleGrower(const FillWindow& window, const Settings& settings, JobContext& context);
    Synthesis run();

    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);

private:
    void grow(int level);
    void offer(int level, const PositionMap& map);

    const FillWindow& m_window;
    const Request& m_request; ///< the window's
    const Settings& m_settings;
    JobContext& m_context;
    ExemplarPyramid m_pyramid;
    std::vector<FillScale> m_scales; ///< from fine to coarse
    PositionMap m_map;               ///< of what is made, at the present scale
};

} // namespace texloom::efros_leung
