#pragma once

#include "core/image/image.h"

#include <span>

namespace texloom {

/// The coefficients of all whole patches of an image: the scalar product of each patch with a direction, and
/// the transpose of this map. On an axis that wraps, the image is padded with its own first pixels, so that
/// patches wrap around.
class PatchProjection {
public:
    PatchProjection(Size image, Wrap wrap, int patch);

    /// How many patches there are in each direction.
    Size positions() const { return m_positions; }
    /// Of the image with its padding.
    Size padded() const { return {m_positions.width + m_patch - 1, m_positions.height + m_patch - 1}; }
    /// Fills the padding. @param image of the padded size.
    void pad(Image& image) const;

    /// Writes row `y` of the products. @param padded the image. @param direction channels × patch × patch
    /// numbers. @param to positions().width floats.
    void projectRow(const Image& padded, std::span<const float> direction, int y, float* to) const;
    /// Adds to row `y` of a channel the sum of the directions times their numbers, over all patches that
    /// cover a pixel. @param numbers one channel for each direction, of the size positions().
    /// @param directions one after another. @param to width floats.
    void spreadRow(const Image& numbers, std::span<const float> directions, int channel, int channels, int y,
                   float* to) const;
    /// How many patches cover a pixel.
    int covering(int x, int y) const;

private:
    static int coveringAlong(int at, int length, int patch, bool wraps);

    Size m_size;
    Wrap m_wrap;
    int m_patch;
    Size m_positions;
};

} // namespace texloom
