#pragma once

#include "core/generator/generator.h"
#include "core/volume/volume_source.h"

#include <memory>

namespace texloom {

/// A generator as a solid without end: what is asked for is made in blocks, so that large boxes take little
/// more memory than themselves.
class GeneratorSource : public VolumeSource {
public:
    /// Longest side of a block.
    static constexpr int kBlock = 64;

    /// @param period see GeneratorNoise.
    GeneratorSource(std::shared_ptr<const Generator> generator, std::uint64_t seed,
                    const VolumeSize& period = {})
        : m_generator(std::move(generator)), m_noise(seed, period), m_period(period) {}

    int channels() const override { return m_generator->shape().channels; }
    VolumeSize period() const override { return m_period; }

private:
    void fill(const Box& box, Volume& volume, JobContext& context) const override;

    std::shared_ptr<const Generator> m_generator;
    GeneratorNoise m_noise;
    VolumeSize m_period;
};

/// The solid that a model of the kind kSolidGenerator makes. @throws Error if it is none.
std::shared_ptr<const GeneratorSource> solidOf(const Model& model, std::uint64_t seed,
                                               const VolumeSize& period = {});

} // namespace texloom
