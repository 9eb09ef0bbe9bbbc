#pragma once

#include "core/job/job_context.h"
#include "core/match/exemplar_pyramid.h"
#include "core/methods/pixel_grower.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <vector>

namespace texloom::efros_leung {

/// Grows a whole output from coarse to fine: on the coarsest scale from a seed, as Efros & Leung do, and on
/// each finer one with the coarser one's result as a guess of what is not made yet, so that windows see all
/// around a pixel, and large structures without large windows. On coarse scales the seams between copies are
/// moved to where they are seen least.
class ScaleGrower {
public:
    /// @param request with nothing known. Must outlive the grower, as must the settings.
    ScaleGrower(const Request& request, const pixel_growth::Settings& settings, JobContext& context);
    Synthesis run();

    static std::uint64_t bytesFor(const Request& request, const pixel_growth::Settings& settings,
                                  int threads);

private:
    int levels() const { return static_cast<int>(m_sizes.size()); }
    Synthesis grow(int level, const PositionMap& coarser);

    const Request& m_request;
    const pixel_growth::Settings& m_settings;
    JobContext& m_context;
    ExemplarPyramid m_pyramid;
    std::vector<Size> m_sizes; ///< of the output, from fine to coarse
};

} // namespace texloom::efros_leung
