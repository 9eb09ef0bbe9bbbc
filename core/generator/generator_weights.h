#pragma once

#include "core/io/model_file.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// The kind of model that a generator is as a file, and the id of ports for it: one for solids, one for
/// pictures.
inline constexpr std::string_view kSolidGenerator = "solid-generator",
                                  kPictureGenerator = "texture-generator";

/// How large a generator is.
struct GeneratorShape {
    int dimensions = 3;    ///< 3, or 2 for pictures
    int coarsest = 5;      ///< K: scales are 0 to K
    int noiseChannels = 3; ///< M_i
    int step = 4;          ///< M_s: the joined block of scale k has (K − k + 1) M_s channels
    int channels = 3;      ///< of the output

    /// Channels of a scale's joined block; of the coarsest, of its only block.
    int joinedChannels(int scale) const { return (coarsest - scale + 1) * step; }
    /// Weights of a filter for one input channel: 27 or 9.
    int taps() const { return dimensions == 3 ? 27 : 9; }
    /// By this rectifiers multiply what is below 0: nothing of it is left of pictures, as published.
    float slope() const { return dimensions == 3 ? 0.01F : 0.0F; }
    friend bool operator==(const GeneratorShape&, const GeneratorShape&) = default;
};

/// y = scale · (x − mean) / √(variance + kEpsilon) + shift, of each channel (Ioffe & Szegedy 2015). Mean and
/// variance are running ones, for evaluation.
struct Normalisation {
    static constexpr double kEpsilon = 1e-5;

    std::vector<float> scale, shift, mean, variance;

    /// Scale 1 and variance 1, the others 0.
    static Normalisation identity(int channels);
    double factor(std::size_t channel) const;
    int channels() const { return static_cast<int>(scale.size()); }
};

/// A convolution without padding.
struct FieldFilters {
    int outputs = 0, inputs = 0, taps = 1; ///< taps: 27 (3 × 3 × 3), 9 (3 × 3) or 1
    std::vector<float> weights;            ///< outputs × inputs × taps, in taps x fastest, then y, then z
    std::vector<float> bias;               ///< outputs

    static FieldFilters zero(int outputs, int inputs, int taps);
    const float* filter(int output, int input) const {
        return weights.data() + (static_cast<std::ptrdiff_t>(output) * inputs + input) * taps;
    }
    float* filter(int output, int input) {
        return weights.data() + (static_cast<std::ptrdiff_t>(output) * inputs + input) * taps;
    }
};

/// A convolution, its normalisation, and a rectifier.
struct GeneratorLayer {
    FieldFilters filters;
    Normalisation norm;
};
/// No rectifier: what is below 0 is multiplied by 1.
inline constexpr float kStraight = 1;
/// Three of them: 3 × 3 × 3, again, and 1 × 1 × 1.
using GeneratorBlock = std::array<GeneratorLayer, 3>;

/// All that a generator has learned.
struct GeneratorWeights {
    struct Scale {
        GeneratorBlock noise; ///< what makes features of the noise
        Normalisation up,
            side; ///< of the coarser scale's features, and of those of the noise, before both are joined
        GeneratorBlock joined;
    };

    GeneratorShape shape;
    std::vector<Scale> scales; ///< K + 1; of the coarsest only `noise` counts
    FieldFilters last;         ///< 1 × 1 × 1, to the output's channels
    /// The output: mean + mix · what comes of `last`.
    std::vector<float> mean, mix; ///< channels, and channels × channels row by row

    /// Filters drawn at random, uniformly within ±1 / √inputs, the rest as it does nothing.
    static GeneratorWeights drawn(const GeneratorShape& shape, std::uint64_t seed);

    /// Weights and biases of all convolutions: 84,219 for the default shape, 115,347 of Ulyanov's pictures.
    std::int64_t convolutionNumbers() const;
    /// Calls `visit` for every list of numbers that is learned, in a fixed order, with its name.
    void everyLearned(const std::function<void(const std::string&, std::vector<float>&)>& visit);
    /// The same for the running means and variances.
    void everyRunning(const std::function<void(const std::string&, std::vector<float>&)>& visit);

    std::shared_ptr<Model> model() const;
    /// @throws Error in one sentence if it is another kind of model, damaged, or too large.
    static GeneratorWeights from(const Model& model);
};

} // namespace texloom
