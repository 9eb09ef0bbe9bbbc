#pragma once

#include "core/image/image.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// Pictures painted in a few flat colours, each of which stands for a material, as image analogies take them.
/// While such a picture is painted, it is one channel with the index of each pixel's colour in a palette.
namespace texloom::labels {

/// One value for each channel.
using Colour = std::vector<float>;
using Palette = std::vector<Colour>;

/// More colours than these nobody paints by hand.
inline constexpr std::size_t kMostColours = 32;

/// The colours of a picture, in the order in which its rows have them first; none if there are more than
/// `most`.
std::optional<Palette> flatColours(const ImageView& picture, std::size_t most);

/// Colours that are easily told apart, at most eight: greys for one channel, else colours in the first three
/// channels and 1 in all further ones.
Palette usualColours(int channels);

/// The colours of `first`, then those of `more` that are not among them, at most `most` in all.
Palette joined(Palette first, const Palette& more, std::size_t most);

/// The index of each pixel's colour; 0 where a colour is not in the palette.
Image indicesOf(const ImageView& picture, const Palette& palette);

/// The picture that indices stand for, in the palette's channels. @param palette not empty.
Image pictureOf(const ImageView& indices, const Palette& palette);

/// Indices where everything at least half in a shape, one channel of the same size, has become `label`.
Image painted(const ImageView& indices, const ImageView& shape, int label);

/// Indices where the area of one colour about a pixel, joined by sides, has become `label`.
/// @param check called for every row that is filled; may throw.
Image filled(
    const ImageView& indices, int x, int y, int label, const std::function<void()>& check = [] {});

} // namespace texloom::labels
