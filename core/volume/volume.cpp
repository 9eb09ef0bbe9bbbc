#include "core/volume/volume.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>

namespace texloom {

namespace {

std::vector<float> allocated(const VolumeSize& size, int channels) {
    if (size.empty() || channels < 1)
        fail("A volume of {} voxels with {} channels has no voxels.", sizeText(size), channels);
    const std::uint64_t bytes = Volume::bytesFor(size, channels);
    try {
        return std::vector<float>(bytes / sizeof(float));
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {}
    fail("There is not enough memory for a volume of {} voxels with {} channels ({}).", sizeText(size),
         channels, byteText(bytes));
}

} // namespace

Volume::Volume(const VolumeSize& size, int channels)
    : m_size(size), m_channels(channels), m_data(allocated(size, channels)) {}

std::uint64_t Volume::bytesFor(const VolumeSize& size, int channels) {
    std::uint64_t bytes = 0;
    const std::uint64_t sampleBytes = static_cast<std::uint64_t>(channels) * sizeof(float);
    return __builtin_mul_overflow(size.voxels(), sampleBytes, &bytes)
               ? std::numeric_limits<std::uint64_t>::max()
               : bytes;
}

bool sameVoxels(const Volume& a, const Volume& b) {
    if (a.size() != b.size() || a.channels() != b.channels())
        return false;
    for (int z = 0; z < a.depth(); ++z)
        if (!samePixels(a.slice(z), b.slice(z)))
            return false;
    return true;
}

} // namespace texloom
