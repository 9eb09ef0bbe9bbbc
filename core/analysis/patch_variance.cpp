#include "core/analysis/patch_variance.h"

#include "core/match/gaussian_patches.h"
#include "core/match/patch_search.h"

#include <algorithm>

namespace texloom {

std::uint64_t patchVarianceBytesFor(Size image, int channels, const std::vector<int>& sizes) {
    const int smallest = *std::min_element(sizes.begin(), sizes.end());
    return PatchDistances::bytesFor(image, channels, smallest, 1, false) +
           PatchDistances::scratchBytesFor(image, channels);
}

PatchVariance patchVariance(const ImageView& image, const std::vector<int>& sizes,
                            const std::vector<int>& neighbours, int patches, JobContext& context) {
    PatchVariance result{{}, neighbours, {}};
    const auto check = [&context] { context.check(); };
    const int most = *std::max_element(neighbours.begin(), neighbours.end());
    for (const int size : sizes)
        if (size <= image.size().shorterSide())
            result.sizes.push_back(size);
    for (std::size_t i = 0; i < result.sizes.size(); ++i) {
        PatchSearch search({{image, {}}}, result.sizes[i], check);
        const Footprint whole = Footprint::filled({result.sizes[i], result.sizes[i]});
        search.prepare(whole);
        PatchSearch::Scratch scratch = search.scratch();
        std::vector<double>& row = result.deviations.emplace_back(neighbours.size(), 0.0);
        for (int n = 0; n < patches; ++n) {
            const PatchPosition position = search.drawn(context.random().uniform(n, 0));
            search.compute(search.pixels(position), whole, scratch, check);
            const std::vector<ImageView> found = search.pixels(search.nearest(most, scratch));
            for (std::size_t j = 0; j < neighbours.size(); ++j) {
                context.check();
                const auto count = static_cast<std::size_t>(neighbours[j]);
                if (count <= found.size())
                    row[j] += meanPatchDeviation(std::span(found).first(count)) / patches;
                else
                    row[j] = -1;
            }
            context.progress((static_cast<double>(i) + (n + 1.0) / patches) /
                             static_cast<double>(result.sizes.size()));
        }
    }
    return result;
}

} // namespace texloom
