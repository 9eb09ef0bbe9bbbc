#pragma once

#include "core/match/patch_loss.h"
#include "core/math/channel_pca.h"
#include "core/methods/solid_texture/settings.h"
#include "core/network/texture_loss.h"
#include "core/volume/volume.h"

#include <memory>
#include <vector>

namespace texloom::solid_texture {

/// How far slices square to the axes are from their exemplars, and the derivative by their voxels: by a
/// descriptor where the exemplars have one channel or three, and by the distribution of their patches.
class SliceLoss {
public:
    SliceLoss(const Request& request, const Settings& settings, JobContext& context);

    const std::vector<SliceGoal>& goals() const { return m_goals; }
    bool describes() const { return m_describes; }
    /// Whether the exemplars are of one colour, so that there is nothing to compare.
    bool constant() const { return m_colours->components() == 0; }
    /// Principal colours: the mean, and the change of the channels by each component of variance 1, row by
    /// row in channels × channels numbers, of which those without a component are 0.
    const std::vector<float>& mean() const { return m_mean; }
    const std::vector<float>& mix() const { return m_mix; }

    /// @param slice one voxel thick, square to the axis of the goal. @param number of the draw of directions.
    /// @param gradient gets the derivative, times the goal's weight.
    double evaluate(std::size_t goal, const Volume& slice, int number, Volume& gradient, JobContext& context);

    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);
    static double secondsFor(const Request& request, const Settings& settings);

private:
    void learnColours();
    double byDescriptor(std::size_t goal, const Image& picture, Image& gradient, JobContext& context);
    double byPatches(std::size_t goal, const Image& picture, int number, Image& gradient,
                     JobContext& context);

    const Settings& m_settings;
    std::vector<SliceGoal> m_goals;
    double m_whole = 0;
    bool m_describes;
    std::vector<float> m_mean, m_mix;
    std::vector<double> m_means;
    std::unique_ptr<ChannelPca> m_colours;
    Eigen::MatrixXd m_toComponents; ///< components × channels
    std::vector<std::unique_ptr<TextureLoss>> m_descriptors;
    std::vector<PatchLoss> m_patches;
    Tensor m_picture, m_gradient;
};

} // namespace texloom::solid_texture
