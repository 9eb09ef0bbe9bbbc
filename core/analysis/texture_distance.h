#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

#include <array>
#include <span>

namespace texloom {

/// How far the statistics of a texture are from those of its exemplars; 0 where they are the same. A few
/// thousand pixels and patches at random places, the same for every run, represent all of them.
struct TextureDistance {
    static constexpr int kScales = 3;

    /// Share of the pixels in other bins of the colour histograms, the mean over the channels: 0 to 1
    /// (Gutierrez, thesis 2020, fig. 3.9). Bins are 64 quantiles of the exemplars.
    double color = 0;
    /// The same for patches of 8 px along the first and the second principal axis of the exemplars' patches.
    std::array<double, 2> components{};
    /// Sliced Wasserstein distance of patches of 8 px, at full, half and quarter scale, relative to the
    /// exemplars' standard deviation.
    std::array<double, kScales> wasserstein{};
};

/// @param exemplars at least one, each with the result's channels.
TextureDistance textureDistance(const ImageView& result, std::span<const ImageView> exemplars,
                                JobContext& context);

} // namespace texloom
