#pragma once

#include "core/job/job.h"
#include "core/volume/volume_source.h"

#include <functional>
#include <utility>

namespace texloom::test {

/// A volume whose samples all differ, each a simple function of its place.
inline Volume sampleVolume(const VolumeSize& size, int channels) {
    Volume volume(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int z = 0; z < size.depth; ++z)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    volume(x, y, z, c) = static_cast<float>(x + 16 * y + 256 * z + 4096 * c) / 16384.0F;
    return volume;
}

/// A source without end that is a function of the place.
class FunctionSource : public VolumeSource {
public:
    using Function = std::function<double(std::int64_t x, std::int64_t y, std::int64_t z, int channel)>;
    explicit FunctionSource(Function function, int channels = 1)
        : m_function(std::move(function)), m_channels(channels) {}

    int channels() const override { return m_channels; }

private:
    void fill(const Box& box, Volume& volume, JobContext& context) const override {
        context.parallel(0, box.size.depth, [&](int z) {
            for (int c = 0; c < m_channels; ++c)
                for (int y = 0; y < box.size.height; ++y)
                    for (int x = 0; x < box.size.width; ++x)
                        volume(x, y, z, c) =
                            static_cast<float>(m_function(box.x + x, box.y + y, box.z + z, c));
        });
    }

    Function m_function;
    int m_channels;
};

/// A context for work that a test does itself.
class TestContext {
public:
    explicit TestContext(int threads = 2)
        : m_context(
              {1, threads, false}, [] { return false; }, m_monitor) {}
    operator JobContext&() { return m_context; }

private:
    JobMonitor m_monitor;
    JobContext m_context;
};

} // namespace texloom::test
