#pragma once

#include "core/image/size.h"
#include "core/match/patch_distances.h"

#include <vector>

namespace texloom {

/// A curve that separates two pictures: straight pieces and arcs, followed with the second picture on the
/// right. Coordinates are in pixels, (0.5, 0.5) in the middle of the top left one.
class BlendCurve {
public:
    /// A place by the length along the curve and the distance to the right, in pixels; negative distances lie
    /// in the first picture.
    struct Place {
        double along = 0, across = 0;
    };
    struct Point {
        double x = 0, y = 0;
    };

    /// Through the pixel centres of row `y`, the first picture above.
    static BlendCurve horizontal(Size size, int y);
    /// Through the pixel centres of column `x`, the first picture on the left.
    static BlendCurve vertical(Size size, int x);
    /// A quarter of a circle around the bottom right corner, the second picture inside (Raad, thesis 2016,
    /// section 4.3.3).
    static BlendCurve circular(Size size, double radius);
    /// The shapes of curves that separate whole pictures.
    enum class Shape { Horizontal, Vertical, Circular };
    /// @param position where it lies, from 0 (top, left, the whole circle) to 1.
    static BlendCurve at(Shape shape, double position, Size size);
    /// Along the middle of a patch's overlap, the patch inside: one curve for each run of adjacent borders.
    /// Where they meet, the curve is an arc that leaves room for a band within the overlap; the source's arc
    /// around the far corner would leave the overlap unless the overlap is a third of the patch.
    static std::vector<BlendCurve> around(const Overlap& overlap, int patch);

    double length() const { return m_length; }
    /// The place on the nearest piece.
    Place placeOf(const Point& point) const;
    Point pointAt(const Place& place) const;

private:
    struct Piece {
        Point from;    ///< where it starts, or an arc's centre
        double dx, dy; ///< direction at the start
        double length; ///< along the curve
        double radius; ///< 0 for a straight piece; arcs turn right
        double start;  ///< length before it
    };
    void addLine(const Point& from, const Point& to);
    void addArc(const Point& centre, double radius, double dx, double dy);
    Place placeOn(const Piece& piece, const Point& point) const;

    std::vector<Piece> m_pieces;
    double m_length = 0;
};

} // namespace texloom
