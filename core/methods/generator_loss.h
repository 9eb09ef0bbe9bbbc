#pragma once

#include "core/image/image.h"
#include "core/match/patch_loss.h"
#include "core/math/channel_pca.h"
#include "core/network/texture_loss.h"

#include <memory>
#include <span>
#include <vector>

namespace texloom {

/// A picture that what a generator makes is to look like, and how much it counts beside others.
struct GeneratorGoal {
    Image exemplar;
    double weight = 1;
};

/// What generators are trained by.
struct GeneratorLossOptions {
    TextureLossOptions texture = {};
    double descriptorWeight = 1; ///< 0: the descriptor is not asked
    double patchWeight = 1; ///< of the distribution of patches; they count 1 where no descriptor is asked
    /// Whether the derivatives by descriptor and by patches are brought to a length of 1 before they are
    /// weighed and added: they differ by orders of magnitude, and by as much from the first iterations to
    /// the last ones, which Adam would remember (Ulyanov et al. 2016).
    bool unitLengths = true;
};

/// How far pictures that a generator makes are from their exemplars, and the derivative by their pixels: by
/// the feature maps of a descriptor, and by the distribution of their patches (Gutierrez, thesis 2020, eqs.
/// 4.2 and 4.4; Elnekave & Weiss 2022).
class GeneratorLoss {
public:
    /// @param goals of the same number of channels. @param descriptor null: only patches are compared.
    GeneratorLoss(std::span<const GeneratorGoal> goals, const Descriptor* descriptor,
                  const GeneratorLossOptions& options, JobContext& context);

    /// Whether the exemplars are of one colour, so that there is nothing to compare.
    bool constant() const { return m_colours->components() == 0; }
    bool describes() const { return m_describes; }
    bool comparesPatches() const { return m_options.patchWeight > 0 || !m_describes; }
    /// Principal colours: the mean, and the change of the channels by each component of variance 1, row by
    /// row in channels × channels numbers, of which those without a component are 0.
    const std::vector<float>& mean() const { return m_mean; }
    const std::vector<float>& mix() const { return m_mix; }

    /// @param edges how the picture goes on beyond its edges, for the descriptor. @param number of the draw
    /// of directions. @param gradient of the picture's size and channels: the derivative is added.
    double evaluate(std::size_t goal, const Image& picture, Edges edges, int number, Image& gradient,
                    JobContext& context);

    /// Bytes for exemplars of these sizes and pictures of `side`. @param descriptor may be null.
    static std::uint64_t bytesFor(std::span<const Size> exemplars, Size side, int channels,
                                  const Descriptor* descriptor, const GeneratorLossOptions& options,
                                  int threads);
    /// Rough seconds to compare one picture with each of the exemplars.
    static double secondsFor(std::span<const Size> exemplars, Size side, const Descriptor* descriptor,
                             const GeneratorLossOptions& options);

private:
    void learnColours(std::span<const GeneratorGoal> goals);
    void add(const Image& change, double weight, Image& gradient) const;
    double byDescriptor(std::size_t goal, const Image& picture, Edges edges, Image& gradient,
                        JobContext& context);
    double byPatches(std::size_t goal, const Image& picture, int number, Image& gradient,
                     JobContext& context);

    GeneratorLossOptions m_options;
    bool m_describes;
    std::vector<float> m_mean, m_mix;
    std::vector<double> m_means;
    std::unique_ptr<ChannelPca> m_colours;
    Eigen::MatrixXd m_toComponents; ///< components × channels
    std::vector<std::unique_ptr<TextureLoss>> m_descriptors;
    std::vector<PatchLoss> m_patches;
    Tensor m_gradient;
};

} // namespace texloom
