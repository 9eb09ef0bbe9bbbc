#pragma once

#include "core/job/job_context.h"
#include "core/match/exemplar_pyramid.h"
#include "core/match/grid_match.h"
#include "core/match/patch_proposals.h"
#include "core/methods/patchmatch/settings.h"
#include "core/methods/synthesis.h"

#include <vector>

namespace texloom::patchmatch {

/// The weight of the proposal of a patch at squared distance d from its match, for mean distance D: (soft + d
/// / D)^-power. A high power lets the best patches decide; a low one looks for agreement.
struct VoteWeight {
    float soft;
    int power;

    float of(float distance) const {
        const float base = 1 / (soft + distance);
        float weight = base;
        for (int i = 1; i < power; ++i)
            weight *= base;
        return weight;
    }
};

/// Synthesises from coarse to fine: on each scale the patches of the output look for similar ones in the
/// exemplar (PatchMatch), and every pixel becomes a copy of the pixel, among those its patches propose, that
/// is nearest to their weighted mean (the discrete solver of Han et al., "Fast example-based surface texture
/// synthesis via discrete optimization", 2006). So the whole state is a position map; the output of a scale
/// is the same map in the next one's pixels. The canvas closes on both axes.
class Synthesizer {
public:
    /// Pixels from one patch to the next.
    static constexpr int kStride = 2;

    Synthesizer(const Request& request, const Settings& settings, JobContext& context);
    Synthesis run();

    /// Size of the canvas for this output.
    static Size canvasFor(Size output, Wrap wrap, int patch);
    /// Number of scales used.
    static int levelsFor(const Request& request, const Settings& settings);

private:
    Size canvas(int level) const;
    void startRandom(GridMatcher& matcher, PatchField& field);
    void startFrom(const ImageView& image, GridMatcher& matcher, PatchField& field);
    void refine(int level, GridMatcher& matcher, PatchField& field);
    void adopt(const GridMatcher& matcher, PatchField& field) const;
    void gather(const GridMatcher& matcher, int x, int y, Size extent, Interleaved& to) const;
    void vote(const GridMatcher& matcher, const PatchField& field, const VoteWeight& weight);
    void carryUp(int level);
    void offer(int level);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    ExemplarPyramid m_pyramid;
    PositionMap m_map; ///< of the current scale
};

} // namespace texloom::patchmatch
