#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/patch_match.h"
#include "core/match/patch_projection.h"
#include "core/math/histogram.h"
#include "core/methods/patch_distribution/settings.h"

#include <span>
#include <vector>

namespace texloom::patch_distribution {

/// Changes an image until its patches are distributed as those of the exemplars are, at one scale: along
/// random directions of the space of patches the products of both are sorted, and each patch is drawn to
/// where the exemplars' patch of its rank lies (sliced optimal transport: Rabin, Peyré, Delon & Bernot 2011).
/// What overlapping patches want of a pixel is averaged, and Adam follows it (Kingma & Ba 2015), as Elnekave
/// & Weiss 2022 do: random directions show little of what is wrong with a patch, and moving by that alone
/// stays at the noise or blur that it began with.
class Matcher {
public:
    /// @param exemplars at this scale. @param size of the image; sides of at least a patch.
    /// @param reach how far a pixel moves at most in one iteration at full pace, for each channel.
    Matcher(std::span<const PatchSource> exemplars, Size size, Wrap wrap, const Settings& settings,
            std::vector<double> reach, JobContext& context);

    /// One iteration. @param number of the iteration over all scales, for drawing directions.
    /// @param pace share of the reach. @return the mean square of what patches lack along a direction.
    double step(Image& image, int number, double pace);

    static std::uint64_t bytesFor(std::span<const Size> exemplars, Size size, int channels,
                                  const Settings& settings, int threads);

private:
    struct Workspace {
        SampleRanks ranks;
        std::vector<float> wanted;
    };

    std::vector<float> drawDirections(int number) const;
    Histogram wantedAlong(std::span<const float> direction, Workspace& work) const;
    double moveAlong(int k, std::span<const float> direction);
    void move(Image& image, std::span<const float> directions, double pace);

    std::vector<PatchSource> m_exemplars;
    std::vector<Image> m_images; ///< the exemplars, as the projection wants them
    std::vector<PatchProjection> m_views;
    /// Of each patch of each exemplar whether the masks allow it; empty where there is none.
    std::vector<std::vector<bool>> m_allowed;
    const Settings& m_settings;
    JobContext& m_context;
    PatchProjection m_projection;
    Image m_padded;
    Image m_numbers; ///< one channel for each direction
    std::vector<double> m_reach;
    Image m_means, m_squares; ///< Adam's, of what is wanted of each value
    int m_moves = 0;
    bool m_alike; ///< whether all exemplars weigh the same
    Pool<Workspace> m_pool;
};

} // namespace texloom::patch_distribution
