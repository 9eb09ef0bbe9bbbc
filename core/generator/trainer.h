#pragma once

#include "core/generator/generator_noise.h"
#include "core/generator/intervals.h"
#include "core/generator/layer_tape.h"
#include "core/volume/volume.h"

#include <array>
#include <string>
#include <vector>

namespace texloom {

/// A generator while it learns (Gutierrez, thesis 2020, section 4.4): boxes are made with the statistics of
/// their own features, derivatives of a loss go the way back, and Adam (Kingma & Ba 2015) changes the
/// weights. The same bits for any number of threads.
class GeneratorTrainer {
public:
    explicit GeneratorTrainer(GeneratorWeights weights);

    const GeneratorWeights& weights() const { return m_weights; }
    /// The voxels of a box, usually one slice.
    const Volume& forward(const Box& box, const GeneratorNoise& noise, JobContext& context);
    /// Adds the derivative by all weights of a loss whose derivative by the last box's voxels this is.
    void backward(const Volume& gradient, JobContext& context);
    /// One step of Adam along what was added, which is 0 then.
    void step(double rate);
    /// Whether all that was added are numbers.
    bool finite();
    /// The derivatives so far, in the shape of the weights.
    const GeneratorWeights& gradients() const { return m_gradients; }

    /// All that training goes on from, bit for bit. @throws Error if `text` does not suit the weights' shape.
    std::string state() const;
    void restore(const std::string& text);

    /// Bytes for a box of this size.
    static std::uint64_t bytesFor(const GeneratorShape& shape, const VolumeSize& size);

private:
    using BlockTape = std::array<LayerTape, 3>;
    struct ScaleTape {
        Field noise, enlarged, joined;
        const Field* output = nullptr;
        BlockTape noiseBlock, joinedBlock;
        ChannelStatistics up, side;
        const Field* sideField = nullptr;
    };

    const Field& runBlock(GeneratorBlock& block, BlockTape& tape, const Field& in, JobContext& context);
    void blockBackward(const GeneratorBlock& block, BlockTape& tape, const Field& gradient,
                       GeneratorBlock& sums, Field* inGradient, JobContext& context);
    void enlarge(int scale, JobContext& context);
    void gather(int scale, JobContext& context);
    void colour(const Box& box, JobContext& context);

    GeneratorWeights m_weights, m_gradients;
    std::vector<std::vector<float>> m_first, m_second; ///< moments of every list
    std::int64_t m_steps = 0;
    std::vector<ScaleBoxes> m_boxes;
    std::vector<CoarserPlaces> m_places;
    std::vector<ScaleTape> m_tapes;
    Field m_colours, m_surrounded, m_gradient, m_next, m_between, m_change;
    Volume m_made;
};

} // namespace texloom
