#pragma once

#include "core/job/job_context.h"
#include "core/match/closed_canvas.h"
#include "core/match/exemplar_pyramid.h"
#include "core/match/patch_proposals.h"
#include "core/match/patch_set.h"
#include "core/methods/synthesis.h"
#include "core/methods/texture_optimization/settings.h"

#include <memory>
#include <optional>
#include <vector>

namespace texloom::texture_optimization {

/// Makes an image whose patches are like the exemplar's (Kwatra et al., SIGGRAPH 2005): projects every patch
/// to its nearest neighbour, joins the neighbours, and repeats, for patches of 32, 16 and 8 px on each scale
/// from coarse to fine. The image closes on both axes.
class Optimizer {
public:
    static constexpr int kSmallestPatch = 8;

    Optimizer(const Request& request, const Settings& settings, JobContext& context);
    Synthesis run();

    /// Size of the canvas for this output.
    static Size canvasFor(Size output, Wrap wrap);
    static int levelsFor(const Request& request, const Settings& settings);

private:
    struct Pass; ///< the work with one patch width on one scale

    Size canvas(int level) const;
    std::vector<int> widths(int level) const;
    void startRandom(int level);
    void optimize(int level, int patch);
    bool project(Pass& pass, int iteration);
    void project(Pass& pass, PatchField& field) const;
    void addInverse(Pass& pass);
    void weigh(Pass& pass);
    void projectInTurn(Pass& pass, int iteration);
    void discourage(Pass& pass);
    static float penaltyOf(const Pass& pass, int number);
    double randomDistance(const Pass& pass) const;
    void aggregate(Pass& pass);
    void finish(Pass& pass);
    void offer() const;
    Image image(int step) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    ExemplarPyramid m_pyramid;
    Size m_size; ///< of the current scale's canvas
    std::optional<ClosedCanvas> m_canvas;
    Synthesis m_result;
};

} // namespace texloom::texture_optimization
