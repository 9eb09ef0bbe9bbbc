#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <functional>

namespace texloom {

/// What a texture is like, as far as it decides which methods suit it. Lengths are in pixels of the exemplar.
struct TextureCharacter {
    Size size; ///< of the exemplar
    /// From 0 to 1: how surely it repeats itself by a lattice (LatticeAnalysis::confidence), or, where
    /// `rowsOnly`, in one direction only.
    double regularity = 0;
    bool rowsOnly = false;
    double period = 0; ///< length of the lattice's shorter vector, or the rows' distance; 0 without either
    /// The distance at which the autocorrelation γ has fallen below kAlike, in the direction in which that is
    /// nearest, and in the one in which it is farthest.
    double shortest = 0, longest = 0;
    /// From 0 to 1: how near it is to a Gaussian field, which its spectrum describes wholly: see
    /// clustering().
    double grain = 0;

    static constexpr double kAlike = 0.2;

    /// `longest` as a share of the exemplar's shorter side.
    double reach() const { return longest / size.shorterSide(); }
};

/// Looks at a picture, at no more than 384 px of it a side: larger ones are halved first.
/// @param check called every few milliseconds; may throw.
TextureCharacter characterOf(
    const ImageView& exemplar, const std::function<void()>& check = [] {});

/// Upper bound of the memory that characterOf() takes.
std::uint64_t characterBytesFor(Size exemplar, int channels);

/// How strong derivatives lie beside other strong ones, as along edges: how far the correlation of the
/// squares of derivatives 3 px apart exceeds the square of their correlation, which it equals in a Gaussian
/// field (Isserlis). The mean over both axes, all channels and three scales, each weighed by its variance. 0
/// for a constant, and for less than seven pixels a side.
double clustering(const ImageView& image);

} // namespace texloom
