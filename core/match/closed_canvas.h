#pragma once

#include "core/job/job_context.h"
#include "core/match/interleaved.h"

namespace texloom {

/// An output that closes on itself on both axes, laid out for patch distances: its first rows and columns are
/// repeated after the last, so that every patch is one rectangle.
class ClosedCanvas {
public:
    /// All 0. @param margin rows and columns that are repeated: those of the largest patch less 1.
    ClosedCanvas(Size size, int channels, int margin);

    /// Without the margin.
    Size size() const { return m_size; }
    int channels() const { return m_channels; }
    /// With the margin.
    const Interleaved& pixels() const { return m_pixels; }
    /// The pixels of row `y`, to be written before close().
    float* row(int y) { return m_pixels.data.data() + y * m_pixels.stride(); }

    /// Takes the image, enlarged where it is smaller than the canvas, and closes.
    void load(const ImageView& image, JobContext& context);
    /// Repeats the first rows and columns after the last.
    void close(JobContext& context);
    /// Every `step`-th pixel.
    Image image(int step, JobContext& context) const;

private:
    Size m_size;
    int m_channels;
    int m_margin;
    Interleaved m_pixels;
};

} // namespace texloom
