#pragma once

#include "core/generator/field_convolution.h"
#include "core/generator/generator_noise.h"
#include "core/generator/generator_weights.h"
#include "core/generator/intervals.h"
#include "core/job/pool.h"
#include "core/volume/volume.h"

#include <array>
#include <memory>
#include <vector>

namespace texloom {

/// A trained generator ready to be evaluated (Gutierrez, thesis 2020, section 4.3): normalisation, with its
/// running statistics, is folded into the convolutions. Any box alone has the bits that it has in a larger
/// one.
class Generator {
public:
    explicit Generator(const GeneratorWeights& weights);

    const GeneratorShape& shape() const { return m_shape; }
    /// The voxels of a box. @param noise of the generator's. @throws Cancelled
    Volume evaluate(const Box& box, const GeneratorNoise& noise, JobContext& context) const;
    /// Bytes in flight while a box of this size is evaluated.
    static std::uint64_t bytesFor(const GeneratorShape& shape, const VolumeSize& size);
    /// Multiplications for a box of this size.
    static double productsFor(const GeneratorShape& shape, const Box& box);

private:
    using Block = std::array<FieldConvolution, 3>;
    struct Scale {
        Block noise, joined;
    };
    struct Buffers {
        Field noise, first, second, side, joined;
        std::vector<Field> outputs;
    };

    void runBlock(const Block& block, const Field& in, Field& out, Buffers& buffers,
                  JobContext& context) const;
    void join(const Field& up, const Box& box, const CoarserPlaces& places, Buffers& buffers,
              JobContext& context) const;

    GeneratorShape m_shape;
    std::vector<Scale> m_scales;
    FieldConvolution m_last;
    mutable Pool<Buffers> m_buffers;
};

} // namespace texloom
