#pragma once

#include "core/image/warp.h"
#include "core/job/random.h"

#include <memory>
#include <vector>

namespace texloom {

/// Ways to deform the plane lightly: three along one axis (Raad, thesis 2016, section 5.5, figure 5.30), and
/// one that swirls along both.
enum class AnamorphosisKind { Affine, Parabola, Sinusoid, Turbulence };

/// The axis that the first three deform.
enum class AnamorphosisAxis { X, Y };

/// What an Anamorphosis is drawn by.
struct AnamorphosisOptions {
    AnamorphosisKind kind = AnamorphosisKind::Sinusoid;
    AnamorphosisAxis axis = AnamorphosisAxis::X;
    double amplitude = 0.5; ///< 0 moves nothing; below 1
    int frequency = 3;      ///< waves of the sinusoid over the plane
    double scale = 64;      ///< deviation in px of the Gaussian that blurs the turbulence, at least 1
};

/// A deformation of a rectangle without folds: maps points of the deformed picture to those they come from.
/// With t the place along the axis over its length, and a the amplitude with a sign drawn at random:
/// - affine: straight from (0, 0) to (c, c + a c (1 − c)) and on to (1, 1), c drawn between 0.3 and 0.7;
/// - parabola: t + a t (1 − t);
/// - sinusoid: t + a / (2π f) (sin(2π f t + p) − sin p), p drawn where the axis wraps, else 0;
/// each of which keeps the ends and has a derivative of at least 1 − |a|;
/// - turbulence: x + a' scale (F, G), two fields of white Gaussian noise blurred by a Gaussian of `scale`,
///   of deviation 1 and mean 0. They are cubic B-splines on a lattice of half that spacing, whose derivatives
///   lie between the differences of neighbouring coefficients. So the Jacobian's determinant is bounded from
///   below in each cell of the lattice, and a' is the largest number up to a for which all bounds are above
///   0.1. As the displacement is bounded, too, the map is one to one (Hadamard).
/// The lattice repeats after 256 nodes, so that its cost does not grow with the plane; along an axis that
/// wraps its period divides the length.
class Anamorphosis : public WarpField {
public:
    /// @param plane of the deformed picture, which is that of the points it comes from.
    Anamorphosis(Size plane, const AnamorphosisOptions& options, Wrap wrap, const Random& random);

    PlanePoint toSource(PlanePoint point) const override;
    Eigen::Matrix2d jacobian(PlanePoint point) const override;

    /// Source points and derivatives along a row of points, `count` of them from (x, y) on, 1 apart.
    /// @param jacobians null where nobody asks for them.
    void row(double x, double y, int count, PlanePoint* points, Eigen::Matrix2d* jacobians) const;

    /// The amplitude in effect, without sign: of turbulence, what was left of it.
    double amplitude() const { return m_amplitude; }
    /// No determinant of a Jacobian is smaller.
    double leastDeterminant() const { return m_leastDeterminant; }
    bool alongY() const { return m_alongY; }
    bool turbulent() const { return m_kind == AnamorphosisKind::Turbulence; }
    /// Along the deformed axis: the source's place for a place, both in pixels. Of the three kinds alone.
    double along(double at) const;
    static std::uint64_t bytesFor();

private:
    /// The places along one axis at which coefficients of the turbulence lie.
    struct Nodes {
        int count = 1;      ///< until they repeat
        double spacing = 1; ///< px
    };
    /// Four neighbouring coefficients' weights at a place, and those of their derivative in px.
    struct Weights;
    /// Bounds of what the determinant is made of in a cell of the lattice, at an amplitude of 1.
    struct Bounds {
        double alongX, alongY, product; ///< least dF/dx and dG/dy, largest dF/dy dG/dx
    };

    double slope(double at) const;
    double length() const { return m_alongY ? m_plane.height : m_plane.width; }
    static Nodes nodesFor(int length, double scale, bool wraps);
    void makeTurbulence(double scale, const Random& random);
    std::vector<double> blurredNoise(const Random& random, std::uint32_t stream) const;
    void blur(std::vector<double>& values, bool alongY) const;
    void normalise(std::vector<double>& values) const;
    std::vector<Bounds> bounds(double scale) const;
    static double least(const std::vector<Bounds>& bounds, double amplitude);
    std::size_t node(int x, int y) const;

    Size m_plane;
    AnamorphosisKind m_kind;
    bool m_alongY;
    double m_amplitude, m_signed = 0, m_leastDeterminant = 1;
    double m_knot = 0.5, m_frequency = 1, m_phase = 0;
    Nodes m_columns, m_rows;
    std::vector<double> m_moveX, m_moveY; ///< coefficients in px, by rows
};

} // namespace texloom
