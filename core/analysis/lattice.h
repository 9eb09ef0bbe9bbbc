#pragma once

#include "core/image/size.h"

#include <cmath>

namespace texloom {

/// A point or displacement in the plane, in pixels; y points down.
struct Vec2 {
    double x = 0;
    double y = 0;

    double length() const { return std::hypot(x, y); }
    friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
    friend double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
    friend double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// Whether a lattice's vector, of about one pixel, only says the direction of rows: along them all
/// displacements are allowed.
inline bool alongRows(Vec2 vector) {
    constexpr double kStep = 1.5;
    return vector.length() < kStep;
}

/// The translations a v1 + b v2, for whole a and b, under which a texture stays as it is (López Recas 2011,
/// section 3.3). The parallelogram that the two vectors span is the tile.
struct Lattice {
    Vec2 v1{1, 0};
    Vec2 v2{0, 1};

    Vec2 at(double a, double b) const { return a * v1 + b * v2; }
    /// The (a, b) for which at(a, b) is `point`.
    Vec2 coordinates(Vec2 point) const {
        const double area = cross(v1, v2);
        return {cross(point, v2) / area, cross(v1, point) / area};
    }
    /// The lattice point whose coordinates those of `point` round to.
    Vec2 nearest(Vec2 point) const {
        const Vec2 c = coordinates(point);
        return at(std::round(c.x), std::round(c.y));
    }
    /// Area of the tile.
    double area() const { return std::abs(cross(v1, v2)); }
    /// Sides of the smallest upright rectangle round the tile.
    Vec2 extent() const { return {std::abs(v1.x) + std::abs(v2.x), std::abs(v1.y) + std::abs(v2.y)}; }
    /// Whether only rows repeat: one of the vectors is alongRows().
    bool rowsOnly() const { return alongRows(v1) != alongRows(v2); }
    /// How long an exemplar is square to the rows, in pixels times the length of the vector along them, as is
    /// area(). @pre rowsOnly()
    double acrossRows(Size exemplar) const;
    /// Whether rows lie so far apart that an exemplar does not show whether they repeat: they come in the
    /// order that they have in it, and each from one place.
    bool keepsOrder(Size exemplar) const;
    /// Whether every displacement is allowed: the lattice of a texture without one.
    bool free() const { return *this == Lattice{}; }

    /// The same translations by the two shortest vectors, at 60 to 120° to each other (Lagrange and Gauss;
    /// the source's observation iv). v1 is the one nearer to the x axis and points right, v2 points down.
    Lattice reduced() const;
    /// Whether each translation of `other` is one of these, to within `tolerance` pixels for the shortest.
    bool includes(const Lattice& other, double tolerance) const;
    /// Whether both have the same translations, to within `tolerance` pixels for each of the shortest.
    bool like(const Lattice& other, double tolerance) const;
    friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// The lattice, changed as little as can be, under which an output of `size` closes on itself on the axes of
/// `wrap`: (width, 0) and (0, height) become whole combinations of its vectors.
struct WrappedLattice {
    Lattice lattice;
    /// Largest share by which a length changes; 0 where the size is a whole number of periods.
    double stretch = 0;
};
WrappedLattice wrapped(const Lattice& lattice, Size size, const Wrap& wrap);

/// The smallest rectangle that tiles under the lattice with hardly a change of it (less than 1 %), of sides
/// up to `limit`; {0, 0} if there is none.
Size wrappingRectangle(const Lattice& lattice, int limit);

/// The share of the tile's pixels that a rectangle contains at least once, 0 to 1, wherever the rectangle
/// lies: the number of different wrapped coordinates x − Q ⌊Q⁻¹ x⌋ in it over their number |det Q| (eq. 3.25
/// to 3.29). Vectors are rounded to whole pixels.
double tileCoverage(const Lattice& lattice, Size rectangle);

} // namespace texloom
