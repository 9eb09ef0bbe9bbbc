#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

#include <array>
#include <span>
#include <vector>

namespace texloom {

/// How often a quantity takes each value in a texture's exemplars and in the texture, over bins of equal
/// width from `low` to `high`. The shares of each add up to 1.
struct HistogramPair {
    double low = 0, high = 1;
    std::vector<double> exemplar, result;

    double binWidth() const { return (high - low) / static_cast<double>(exemplar.size()); }
    /// Share of the result in other bins than in the exemplar: half the sum of the differences, 0 to 1.
    double distance() const;
};

/// One pair for each channel. @param exemplars at least one, each with at least the result's channels.
/// @param context its progress is set.
std::vector<HistogramPair> colorHistograms(const ImageView& result, std::span<const ImageView> exemplars,
                                           int bins, JobContext& context);

/// Patches of 8 px, along the first and the second principal axis of the exemplars' patches (Gutierrez,
/// thesis 2020, fig. 3.9). A few thousand, at places drawn with the context's random numbers, represent all
/// of them. Empty if an image is smaller than a patch.
std::vector<HistogramPair> componentHistograms(const ImageView& result, std::span<const ImageView> exemplars,
                                               int bins, JobContext& context);

} // namespace texloom
