#pragma once

#include "core/job/job_context.h"
#include "core/match/closed_canvas.h"
#include "core/match/exemplar_pyramid.h"
#include "core/match/patch_proposals.h"
#include "core/math/assignment.h"
#include "core/methods/patch_assignment/cost_table.h"
#include "core/methods/patch_assignment/patches.h"
#include "core/methods/synthesis.h"

#include <optional>
#include <vector>

namespace texloom::patch_assignment {

/// Makes an image that has the exemplar's patches, each as often as the exemplar has it (Gutierrez, thesis
/// 2020, algorithm 1): assigns the exemplar's patches to those of the image at the least cost, joins them by
/// geometric medians, and repeats, from coarse to fine. The image closes on both axes.
///
/// The whole cost matrix is assigned at once where that is possible or asked for, else band by band of the
/// output, each with its share of the patches. Where even that would take hours, every patch of the output
/// chooses only among those that fit its neighbours' and ones like them, and a patch may be used a little
/// more often.
class Optimizer {
public:
    Optimizer(const Request& request, const Settings& settings, JobContext& context);
    Synthesis run();

    static Size canvasFor(Size output, Wrap wrap, int patch);
    static int levelsFor(const Request& request, const Settings& settings);
    /// Patches of the exemplars and of the canvas on the finest scale.
    static double exemplarPatches(const Request& request, const Settings& settings);
    /// The maximum number of costs in memory at once.
    static constexpr double kMostCosts = 1.0e8;
    /// The maximum number of costs computed for one scale before choices are narrowed.
    static constexpr double kMostWork = 0.9e9;
    /// The maximum number of patches of the output where many of them share one of the exemplar's: the exact
    /// assignment then moves whole groups.
    static constexpr double kMostSharing = 10000;
    static bool narrows(double rows, double columns, int iterations, Solve solve);
    /// Choices of each patch where they are narrowed.
    static constexpr int kChoices = 32;

private:
    struct Band; ///< rows of the lattice that are assigned together
    struct Pass; ///< the work on one scale

    Size canvas(int level) const;
    int iterations(int level) const {
        return level == 0 ? m_settings.fineIterations : m_settings.coarseIterations;
    }
    bool relaxed() const;
    bool nearOptimal() const { return m_settings.epsilon > 0 || relaxed(); }
    void start(int level);
    void optimize(int level);
    double toleranceAt(int level, int iteration) const;
    void plan(Pass& pass, int level) const;
    double project(Pass& pass);
    double assign(Pass& pass, Band& band);
    static std::vector<int> membersFor(const Pass& pass, const Band& band, std::vector<int> kinds);
    void costSome(Pass& pass, const Band& band) const;
    void choices(const Pass& pass, int x, int y, std::int32_t* list) const;
    AssignmentOptions options(const Pass& pass) const;
    void weigh(Pass& pass) const;
    void aggregate(Pass& pass);
    static double usesTooMany(const Pass& pass);
    void finish(Pass& pass);
    Image image(int step) const;
    void offer() const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    ExemplarPyramid m_pyramid;
    double m_range; ///< of the exemplars' values: the unit of ε and ρ
    Size m_size;
    std::optional<ClosedCanvas> m_canvas;
    std::vector<double> m_costs; ///< mean cost of a patch after each iteration
    Synthesis m_result;
};

} // namespace texloom::patch_assignment
