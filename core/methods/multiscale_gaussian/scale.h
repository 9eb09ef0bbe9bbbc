#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/patch_grower.h"
#include "core/math/zoom.h"
#include "core/methods/multiscale_gaussian/settings.h"
#include "core/methods/synthesis.h"

#include <functional>
#include <optional>
#include <vector>

namespace texloom::multiscale_gaussian {

/// An exemplar at one scale.
struct ExemplarScale {
    Image image; ///< u_k
    Image low;   ///< u_k ∗ G; empty at the coarsest scale
    Image high;  ///< u_k − u_k ∗ G; empty at the coarsest scale
    Image mask;  ///< empty if there is none
};
/// All scales, the finest first.
using ExemplarScales = std::vector<ExemplarScale>;

/// @param check called now and then; may throw.
ExemplarScales exemplarScales(const Exemplar& exemplar, int scales, const std::function<void()>& check);

/// Synthesises one scale of the output: the coarsest as locally Gaussian synthesis, the others by adding
/// samples of the high band to what the coarser scale gave (Raad, thesis 2016, algorithm 5).
class ScaleSampler : public PatchGrower {
public:
    /// @param scale 0 is the finest. @param size of the output at this scale. @param low v_k, the coarser
    /// scale's result zoomed in; empty at the coarsest scale.
    ScaleSampler(const std::vector<ExemplarScales>& exemplars, int scale, const Settings& settings, Size size,
                 Wrap wrap, const Image& low, JobContext& context);

private:
    /// What a thread needs beside the Workspace at all scales but the coarsest.
    struct LowWorkspace {
        Image patch;
        PatchSearch::Scratch search;
    };

    void make(const PatchCell& cell, Workspace& work) override;
    void sample(const PatchCell& cell, const std::vector<ImageView>& patches, Image& to) const;
    std::vector<PatchPosition> neighbours(const PatchCell& cell, Workspace& work, LowWorkspace& low) const;
    std::vector<ImageView> pieces(const std::vector<PatchPosition>& positions) const;

    int m_scale;
    const Settings& m_settings;
    std::optional<PatchSearch> m_lowSearch; ///< over u_k ∗ G
    std::optional<PatchCanvas> m_low;       ///< v_k
    std::vector<ImageView> m_high;
    Pool<LowWorkspace> m_pool;
};

} // namespace texloom::multiscale_gaussian
