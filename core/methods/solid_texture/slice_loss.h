#pragma once

#include "core/methods/generator_loss.h"
#include "core/methods/solid_texture/settings.h"
#include "core/volume/volume.h"

#include <vector>

namespace texloom::solid_texture {

/// How far slices square to the axes are from their exemplars, and the derivative by their voxels: by a
/// descriptor where the exemplars have one channel or three, and by the distribution of their patches.
class SliceLoss {
public:
    SliceLoss(const Request& request, const Settings& settings, JobContext& context);

    const std::vector<Axis>& axes() const { return m_axes; }
    const GeneratorLoss& pictures() const { return m_pictures; }

    /// @param slice one voxel thick, square to the axis of the goal. @param number of the draw of directions.
    /// @param gradient gets the derivative, times the goal's weight.
    double evaluate(std::size_t goal, const Volume& slice, int number, Volume& gradient, JobContext& context);
    /// The pixels of a slice.
    Image pictureOf(const Volume& slice, Axis axis) const;

    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);
    static double secondsFor(const Request& request, const Settings& settings);

private:
    SliceLoss(const std::vector<SliceGoal>& slices, const Request& request, const Settings& settings,
              JobContext& context);

    int m_side;
    std::vector<Axis> m_axes;
    std::vector<float> m_shares; ///< of the goals' weights
    GeneratorLoss m_pictures;
};

} // namespace texloom::solid_texture
