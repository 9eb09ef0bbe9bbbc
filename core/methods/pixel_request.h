#pragma once

#include "core/job/job_context.h"
#include "core/match/exemplar_pyramid.h"
#include "core/match/neighbourhood.h"
#include "core/methods/method.h"

#include <span>
#include <vector>

namespace texloom {

/// What methods that make one pixel after another share.

/// Checks that every exemplar holds a neighbourhood of this side and that the masks leave one.
/// @throws UsageError
void checkSquares(const Request& request, int side);

/// The pixels of every exemplar at every scale, with their channels side by side.
class PixelPyramid {
public:
    /// @param levels wanted; there are fewer where one would leave no square of `side` pixels.
    PixelPyramid(const Request& request, int levels, int side, const std::function<void()>& check);

    int levels() const { return m_pyramid.levels(); }
    const Interleaved& pixels(int level, int exemplar) const {
        return m_pixels[static_cast<std::size_t>(level)][static_cast<std::size_t>(exemplar)];
    }
    int exemplars() const { return static_cast<int>(m_pixels.front().size()); }
    std::vector<Size> sizes(int level) const { return m_pyramid.sizes(level); }
    std::span<const PatchSource> level(int level) const { return m_pyramid.level(level); }

    static std::uint64_t bytesFor(const Request& request);

private:
    ExemplarPyramid m_pyramid;
    std::vector<std::vector<Interleaved>> m_pixels;
};

/// Side of an output at a coarser scale.
Size halvedSize(Size size);

/// Makes a preview of a map whose sources lie in the exemplars' pictures at a scale, if one is looked at.
/// @param images of the exemplars at this scale.
void previewMap(const PositionMap& map, std::span<const PatchSource> images, int level,
                const Request& request, JobContext& context);

} // namespace texloom
