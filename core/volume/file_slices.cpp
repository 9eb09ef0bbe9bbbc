#include "core/volume/file_slices.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/job/memory.h"

#include <algorithm>

namespace texloom {

namespace {

/// Voxels along z that are asked for at once: sources that make what they are asked for do thick boxes for
/// less.
constexpr int kSlab = 32;
constexpr int kMostChannels = 64;

} // namespace

void forEachSlice(const VolumeSource& source, const Box& box, const std::string& space, JobContext& context,
                  const std::function<void(int z, const Image& picture)>& use) {
    for (int begin = 0; begin < box.size.depth; begin += kSlab) {
        const int count = std::min(kSlab, box.size.depth - begin);
        const Volume slab =
            source.sample({box.x, box.y, box.z + begin, {box.size.width, box.size.height, count}}, context);
        for (int z = 0; z < count; ++z) {
            context.check();
            Image picture(slab.slice(z));
            color::fromWorking(picture, space);
            use(begin + z, picture);
            context.progress(static_cast<double>(begin + z + 1) / box.size.depth);
        }
    }
}

void putSlice(Image picture, const std::string& space, int z, Volume& volume) {
    color::toWorking(picture, space);
    for (int c = 0; c < volume.channels(); ++c)
        for (int y = 0; y < volume.height(); ++y)
            std::copy_n(picture.plane(c).row(y), volume.width(), volume.row(y, z, c));
}

void checkVolumeSize(const std::filesystem::path& path, const VolumeSize& size, int channels,
                     std::int64_t largestVoxels) {
    if (size.voxels() > largestVoxels)
        fail("{} is a volume of {} voxels; volumes up to {} voxels can be opened.", path.string(),
             sizeText(size), grouped(static_cast<std::uint64_t>(largestVoxels)));
    if (channels > kMostChannels)
        fail("{} is a volume of {} channels; volumes with up to {} can be opened.", path.string(), channels,
             kMostChannels);
    const std::uint64_t bytes = Volume::bytesFor(size, channels);
    if (const std::uint64_t free = availableMemory(); bytes > free)
        fail("{} is a volume of {} voxels and takes {}; {} of memory are free.", path.string(),
             sizeText(size), byteText(bytes), byteText(free));
}

} // namespace texloom
