#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

#include <cstdint>
#include <vector>

namespace texloom {

/// How much the Gaussian models of patches vary: the mean standard deviation σ̄ of the m patches most similar
/// to one of an image, as a function of the patch size n and m (Raad, thesis 2016, section 2.2, figure 2.2).
struct PatchVariance {
    std::vector<int> sizes;      ///< n that fit the image
    std::vector<int> neighbours; ///< m
    /// deviations[i][j] is σ̄ for sizes[i] and neighbours[j], averaged over the patches examined; negative
    /// where the image has fewer than m patches of this size.
    std::vector<std::vector<double>> deviations;
};

/// Bytes that patchVariance() needs beside the image.
std::uint64_t patchVarianceBytesFor(Size image, int channels, const std::vector<int>& sizes);

/// @param patches number of patches to examine, drawn by place with the context's random numbers.
/// @param context its progress is set.
PatchVariance patchVariance(const ImageView& image, const std::vector<int>& sizes,
                            const std::vector<int>& neighbours, int patches, JobContext& context);

} // namespace texloom
