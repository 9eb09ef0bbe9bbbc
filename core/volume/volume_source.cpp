#include "core/volume/volume_source.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/memory.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

/// What is smaller than this is not held against the memory that is free, which takes a while to find out.
constexpr std::uint64_t kSmallBox = 64U << 20;

/// a modulo b, never negative.
int wrapped(std::int64_t a, int b) {
    const std::int64_t rest = a % b;
    return static_cast<int>(rest < 0 ? rest + b : rest);
}

/// Copies `count` values of a row that repeats, from `begin` on.
void copyWrapped(const float* row, int length, int begin, float* to, int count) {
    while (count > 0) {
        const int part = std::min(count, length - begin);
        to = std::copy_n(row + begin, part, to);
        count -= part;
        begin = 0;
    }
}

} // namespace

Volume VolumeSource::sample(const Box& box, JobContext& context) const {
    box.check();
    if (const std::optional<Box> whole = bounds(); whole && !box.within(*whole))
        failUsage("The box {} is not all within the volume, which has {}.", boxText(box), boxText(*whole));
    const std::uint64_t bytes = Volume::bytesFor(box.size, channels());
    if (bytes > kSmallBox)
        if (const std::uint64_t free = availableMemory(); bytes > free)
            fail("A box of {} voxels takes {}, and {} of memory are free; ask for smaller ones.",
                 sizeText(box.size), byteText(bytes), byteText(free));
    Volume volume(box.size, channels());
    fill(box, volume, context);
    return volume;
}

DenseSource::DenseSource(Volume volume, Edge edge, std::int64_t x, std::int64_t y, std::int64_t z)
    : m_volume(std::move(volume)), m_edge(edge), m_box{x, y, z, m_volume.size()} {
    m_box.check();
}

std::optional<Box> DenseSource::bounds() const {
    return m_edge == Edge::Ends ? std::optional(m_box) : std::nullopt;
}

VolumeSize DenseSource::period() const {
    return m_edge == Edge::Repeats ? m_volume.size() : VolumeSize();
}

void DenseSource::fill(const Box& box, Volume& volume, JobContext& context) const {
    const int left = wrapped(box.x - m_box.x, m_volume.width());
    context.parallel(0, box.size.depth, [&](int z) {
        const int fromZ = wrapped(box.z + z - m_box.z, m_volume.depth());
        for (int c = 0; c < m_volume.channels(); ++c)
            for (int y = 0; y < box.size.height; ++y) {
                const int fromY = wrapped(box.y + y - m_box.y, m_volume.height());
                copyWrapped(m_volume.row(fromY, fromZ, c), m_volume.width(), left, volume.row(y, z, c),
                            box.size.width);
            }
    });
}

} // namespace texloom
