#include "core/generator/generator_source.h"

#include <algorithm>

namespace texloom {

void GeneratorSource::fill(const Box& box, Volume& volume, JobContext& context) const {
    // A slice may be wide, since it is thin.
    const int longest =
        std::min({box.size.width, box.size.height, box.size.depth}) <= 2 ? 4 * kBlock : kBlock;
    for (int z = 0; z < box.size.depth; z += longest)
        for (int y = 0; y < box.size.height; y += longest)
            for (int x = 0; x < box.size.width; x += longest) {
                const auto side = [&](int begin, int whole) { return std::min(longest, whole - begin); };
                const VolumeSize size{side(x, box.size.width), side(y, box.size.height),
                                      side(z, box.size.depth)};
                const Volume block =
                    m_generator->evaluate({box.x + x, box.y + y, box.z + z, size}, m_noise, context);
                for (int c = 0; c < block.channels(); ++c)
                    for (int k = 0; k < size.depth; ++k)
                        for (int j = 0; j < size.height; ++j)
                            std::copy_n(block.row(j, k, c), size.width, volume.row(y + j, z + k, c) + x);
            }
}

std::shared_ptr<const GeneratorSource> solidOf(const Model& model, std::uint64_t seed,
                                               const VolumeSize& period) {
    model.checkKind(kSolidGenerator);
    return std::make_shared<const GeneratorSource>(
        std::make_shared<const Generator>(GeneratorWeights::from(model)), seed, period);
}

} // namespace texloom
