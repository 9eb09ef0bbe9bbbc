#pragma once

#include "core/network/descriptor_network.h"
#include "core/network/tap_statistics.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace texloom {

/// What of a texture is compared, and how.
struct TextureLossOptions {
    Statistic statistic = Statistic::Normalised;
    /// Of the picture's pyramid, each level half the one before, on all of which the descriptor is used.
    int levels = 2;
    std::optional<Pooling> pooling = std::nullopt; ///< the descriptor's own if not given
    int firstTap = 0, lastTap = 1 << 20;           ///< of the descriptor, from 0
    bool colours = true;  ///< compares the distribution of colours as well, as a tap of its own
    double range = 1;     ///< weight of the penalty on values that the exemplar has not
    double variation = 0; ///< weight of the total variation
    bool evenGradients =
        false; ///< the derivative by each tap's maps gets an L1 norm of 1 (Ulyanov et al. 2016)
};

/// A picture to learn from: channels × height × width, values as they are, and how much it counts.
struct LossExemplar {
    const Tensor* picture = nullptr;
    double weight = 1;
};

/// How far a picture's texture is from an exemplar's, and the derivative of that by the picture: feature maps
/// F of a descriptor at its taps are compared by their second moments over all positions (Gatys, Ecker &
/// Bethge 2015; Gutierrez, thesis 2020, eqs. 4.1 and 4.2; see Statistic). Exemplar and picture may have
/// different sizes. For optimising pictures and for training generators.
///
///     TextureLoss loss(descriptor, {}, {{&exemplar, 1}}, context);
///     Tensor gradient;
///     const double value = loss.evaluate(picture, Edges::all(Padding::Circular), &gradient, context);
///
/// The same bits for any number of threads. One object is used by one caller at a time: it keeps its memory.
class TextureLoss {
public:
    /// @param exemplars with the same number of channels, as many as the descriptor's, or 1: a grey picture
    /// is seen as one of three equal channels. They are seen with reflected edges.
    /// @throws Error if the channels do not suit, a side is below leastSide(), or feature maps overflow.
    TextureLoss(const Descriptor& descriptor, const TextureLossOptions& options,
                std::span<const LossExemplar> exemplars, JobContext& context);

    /// The loss. @param gradient gets the picture's shape and the derivative by each of its values; may be
    /// null.
    /// @param edges how the picture goes on beyond its edges.
    double evaluate(const Tensor& picture, Edges edges, Tensor* gradient, JobContext& context);

    /// Of the last evaluation: each tap on each level, as shares of the loss, with the names of termNames().
    const std::vector<double>& terms() const { return m_terms; }
    /// "relu1_1", "relu1_1 ½", …, "colours".
    const std::vector<std::string>& termNames() const { return m_termNames; }

    /// The smallest side of a picture for which every tap has at least one position, times two.
    static int leastSide(const Descriptor& descriptor, int levels);
    /// Bytes for a picture of so many pixels, those of the exemplars included.
    static std::uint64_t bytesFor(const Descriptor& descriptor, const TextureLossOptions& options,
                                  std::uint64_t pixels, int threads);
    /// Rough seconds of an evaluation with its gradient for a picture of so many pixels.
    static double secondsFor(const Descriptor& descriptor, const TextureLossOptions& options, double pixels);

private:
    struct Level {
        Tensor picture, gradient;
    };
    struct Term {
        int level = 0;
        TapTarget target;
    };

    void setRange(std::span<const LossExemplar> exemplars);
    void learn(std::span<const LossExemplar> exemplars, JobContext& context);
    void seen(const Tensor& picture, Tensor& to, JobContext& context) const;
    void fillLevels(const Tensor& picture, JobContext& context);
    double networkTerms(const DescriptorNetwork& network, int level, std::size_t firstTerm, Edges edges,
                        bool gradient, JobContext& context);
    void toPicture(Tensor& gradient, JobContext& context);
    double rangePenalty(const Tensor& picture, Tensor* gradient, JobContext& context) const;
    double variation(const Tensor& picture, Edges edges, Tensor* gradient, JobContext& context) const;

    TextureLossOptions m_options;
    DescriptorNetwork m_network;
    std::optional<DescriptorNetwork> m_colours;
    int m_pictureChannels = 0;
    std::vector<float> m_offset, m_scale;     ///< of each channel that the network sees
    std::vector<float> m_smallest, m_largest; ///< of each channel of the exemplars
    std::vector<double> m_variance;           ///< of each channel of the exemplars
    double m_exemplarVariation = 0;
    std::vector<Term> m_targets; ///< level by level, in each the taps; colours last
    std::vector<double> m_terms;
    std::vector<std::string> m_termNames;
    std::vector<Level> m_levels;
    DescriptorNetwork::Workspace m_work;
    TapWorkspace m_tapWork;
};

} // namespace texloom
