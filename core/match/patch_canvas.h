#pragma once

#include "core/image/image.h"
#include "core/image/mirror.h"
#include "core/job/job_context.h"
#include "core/match/patch_grid.h"

#include <functional>

namespace texloom {

/// An output that grows patch by patch in raster order: the grid of patches and the pixels made so far, which
/// reach beyond the output as far as the last patches do.
class PatchCanvas {
public:
    /// @param overlap of neighbouring patches, at most half of `patch`.
    PatchCanvas(Size output, Wrap wrap, int channels, int patch, int overlap);

    const PatchGrid& grid() const { return m_grid; }
    int patch() const { return m_patch; }
    const Image& image() const { return m_image; }
    Image& image() { return m_image; }
    /// The part of a patch that lies within the output.
    Size visible(const PatchCell& cell) const;

    /// Fills the canvas from an image, mirrored beyond its borders as often as needed.
    void fill(const ImageView& image, JobContext& context);
    /// Copies a patch's part of the canvas, across the border where the output wraps.
    void read(const PatchCell& cell, Image& patch) const;
    /// Places a patch: weight × old + (1 − weight) × fresh, where weights of 0 and 1 copy bit for bit.
    /// @param weight of the old pixels, 0 to 1.
    void place(const PatchCell& cell, const ImageView& old, const ImageView& fresh, const PlaneView& weight);
    /// The same without old pixels.
    void place(const PatchCell& cell, const ImageView& fresh);

    /// Calls body(index) for every cell, those it depends on first, on the context's threads.
    /// @param show called now and then while no body runs, after the progress is set.
    void grow(JobContext& context, const std::function<void(int)>& body,
              const std::function<void()>& show) const;
    /// The canvas cropped to the output, moved out.
    Image take();

    /// Bytes that a canvas takes, its grid and the schedule of its growth included.
    static std::uint64_t bytesFor(Size output, Wrap wrap, int channels, int patch, int overlap);
    /// Number of patches.
    static double countFor(Size output, Wrap wrap, int patch, int overlap);

private:
    Size m_output;
    Wrap m_wrap;
    int m_patch;
    PatchGrid m_grid;
    Image m_image;
};

} // namespace texloom
