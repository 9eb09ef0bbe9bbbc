#pragma once

#include "core/analysis/lattice.h"
#include "core/image/image.h"

#include <cstdint>
#include <string>

namespace texloom::test {

/// What a made-up near-regular texture is like.
struct Regularity {
    double noise = 0;        ///< power of white noise as a share of the texture's variance
    double colourChange = 0; ///< how much each tile's colour differs, as a share of the contrast
    double ramp = 0; ///< rise of the light from one corner to the opposite one, as a share of the contrast
};

/// A texture with exactly this lattice, of any real vectors: a soft figure of random waves, joints along the
/// tile's sides, and a colour for each tile.
Image regularTexture(Size size, int channels, const Lattice& lattice, const Regularity& regularity,
                     std::uint64_t seed);

/// Courses of stones of any length, which nothing but the courses' height repeats.
/// @param along unit vector of the courses. @param distance from course to course in pixels.
Image coursesTexture(Size size, int channels, Vec2 along, double distance, const Regularity& regularity,
                     std::uint64_t seed);

/// Planks of any width, which run through the whole picture: darker and lighter ones with streaks along them
/// and blots that repeat nowhere. @param along unit vector of the planks.
Image planksTexture(Size size, int channels, Vec2 along, double widest, std::uint64_t seed);

/// Squares of 16 px with joints, each second one a little darker: two of them are the tile, or nearly one.
Image nearlyAlikeSquares();

/// One random case of the kinds that a lattice comes in.
struct LatticeCase {
    std::string kind; ///< square, rectangular, hexagonal, oblique or brick bond
    Size size;
    Lattice lattice;
    Regularity regularity;
};

/// Case number `index`: shortest periods from 9 to 90 px, whole and fractional, noise up to −10 dB, changes
/// of colour from tile to tile, ramps of light.
LatticeCase latticeCase(int index);

/// One random case of courses.
struct CoursesCase {
    Size size;
    Vec2 along;
    double distance = 0;
    Regularity regularity;
};

/// Case number `index`: courses 9 to 60 px high, upright or lying and turned a little, otherwise as
/// latticeCase().
CoursesCase coursesCase(int index);

} // namespace texloom::test
