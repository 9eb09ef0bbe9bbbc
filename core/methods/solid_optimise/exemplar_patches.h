#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

#include <cstdint>
#include <span>
#include <vector>

namespace texloom::solid_optimise {

/// All square patches of an exemplar at one scale by their leading principal components, and for each of them
/// a few that are most like it (k-coherence: Tong et al., SIGGRAPH 2002).
class ExemplarPatches {
public:
    ExemplarPatches(Image exemplar, int patch, JobContext& context);

    ImageView exemplar() const { return m_exemplar; }
    /// Patches by the top left of each: number = row × width + column.
    Size positions() const { return m_positions; }
    int count() const { return static_cast<int>(m_positions.area()); }
    /// Number of components, and the weights of one for the channels, rows and columns of a patch; the
    /// component is their product with the patch, less offset().
    int axes() const { return m_axes; }
    const float* axis(int k) const { return m_weights.data() + static_cast<std::ptrdiff_t>(k) * m_length; }
    float offset(int k) const { return m_offsets[static_cast<std::size_t>(k)]; }

    /// Mean square difference of pixels between a patch given by its components and one of the exemplar's.
    float distance(const float* components, std::int32_t number) const;
    /// The nearest of all. @param best its distance.
    std::int32_t nearest(const float* components, float& best) const;
    std::span<const std::int32_t> alike(std::int32_t number) const {
        return {m_alike.data() + static_cast<std::ptrdiff_t>(number) * kAlike, kAlike};
    }
    /// The channels of a pixel: number = row × width of the exemplar + column.
    const float* colour(int number) const {
        return m_colours.data() + static_cast<std::ptrdiff_t>(number) * m_exemplar.channels();
    }

private:
    static constexpr int kAlike = 4;

    void learnAxes(int patch, JobContext& context);
    void describe(int patch, JobContext& context);
    void findAlike(JobContext& context);

    Image m_exemplar;
    Size m_positions;
    int m_length, m_axes = 0;
    std::vector<float> m_weights, m_offsets, m_descriptors, m_colours;
    std::vector<std::int32_t> m_alike;
};

} // namespace texloom::solid_optimise
