#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/match/patch_projection.h"

#include <span>
#include <vector>

namespace texloom {

/// How far the patches of a picture are from being distributed as an exemplar's, and the derivative of that
/// by the picture: along random directions of the space of patches, the mean square distance between patches
/// of the same rank (sliced optimal transport: Elnekave & Weiss 2022), on the picture and on its halves. For
/// training.
class PatchLoss {
public:
    /// @param levels of the pyramid, fewer where the exemplar has no patch there.
    PatchLoss(const ImageView& exemplar, int patch, int levels, int directions);

    /// @param picture with the exemplar's channels. @param number another one draws other directions.
    /// @param gradient of the picture's size and channels: the derivative is added, times `weight`.
    double evaluate(const ImageView& picture, int number, double weight, Image& gradient,
                    JobContext& context) const;

private:
    double level(const Image& exemplar, const Image& picture, int number, double weight, Image& gradient,
                 JobContext& context) const;

    std::vector<Image> m_exemplars; ///< one for each level
    int m_patch, m_directions;
};

} // namespace texloom
