#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/match/patch_source.h"

#include <cstdint>
#include <span>
#include <vector>

namespace texloom {

/// One patch that was found.
struct PatchMatch {
    Source source;      ///< top left pixel of the patch
    float distance = 0; ///< sum of squared differences over all pixels and channels
};

/// For every patch of an image a similar one: the nearest-neighbour field.
class PatchField {
public:
    /// @param size patches in each direction.
    explicit PatchField(Size size) : m_size(size), m_matches(static_cast<std::size_t>(size.area())) {}

    Size size() const { return m_size; }
    PatchMatch& at(int x, int y) { return m_matches[index(x, y)]; }
    const PatchMatch& at(int x, int y) const { return m_matches[index(x, y)]; }
    double meanDistance() const;
    static std::uint64_t bytesFor(Size size) {
        return static_cast<std::uint64_t>(size.area()) * sizeof(PatchMatch);
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
               static_cast<std::size_t>(x);
    }

    Size m_size;
    std::vector<PatchMatch> m_matches;
};

struct PatchMatchOptions {
    int patch = 7; ///< side in pixels, at most the shortest side of all images
    int iterations = 5;
    int startStep = 1; ///< 2 searches a start for only one patch in four: faster, a little less accurate
    Wrap wrap;         ///< axes on which patches of the query wrap around the border
};

/// Approximate nearest neighbours of all patches of `query` among those of `sources`: PatchMatch (Barnes et
/// al., SIGGRAPH 2009). Tiles of the query are scanned as the paper scans the image, those of one colour of
/// the chessboard at a time, and random numbers depend on the place, so the number of threads changes
/// nothing.
/// @param sources at least one, each with the query's channels; together their masks must allow at least one
/// patch.
/// @param context its progress() is set to the share done.
/// @return one match for each top left pixel: (width − patch + 1) × (height − patch + 1), or the whole width
/// or height where the query wraps.
PatchField matchPatches(const ImageView& query, std::span<const PatchSource> sources,
                        const PatchMatchOptions& options, JobContext& context);

} // namespace texloom
