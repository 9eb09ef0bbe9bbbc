#include "core/analysis/texture_character.h"

#include "core/analysis/lattice_detector.h"
#include "core/image/half_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

constexpr int kLargest = 384;   ///< px a side that are looked at
constexpr int kDirections = 16; ///< over half a turn
constexpr double kStep = 0.5;   ///< px along a direction
constexpr double kEdgy = 0.12;  ///< the clustering from which on nothing is left of a Gaussian field

int halvings(Size size) {
    int count = 0;
    for (int side = size.longerSide(); side > kLargest; side /= 2)
        ++count;
    return count;
}

/// Sums over pairs of derivatives a and b at two places.
struct PairMoments {
    double aa = 0, bb = 0, ab = 0, aabb = 0, aaaa = 0, bbbb = 0, count = 0;

    void add(double a, double b) {
        aa += a * a;
        bb += b * b;
        ab += a * b;
        aabb += a * a * b * b;
        aaaa += a * a * a * a;
        bbbb += b * b * b * b;
        ++count;
    }
    /// How far the correlation of a² and b² exceeds the square of that of a and b, which it is for jointly
    /// normal ones of mean 0 (Isserlis).
    double excess() const {
        const double varianceA = aaaa / count - aa * aa / count / count;
        const double varianceB = bbbb / count - bb * bb / count / count;
        if (aa * bb <= 0 || varianceA * varianceB <= 0)
            return 0;
        return (aabb / count - aa * bb / count / count) / std::sqrt(varianceA * varianceB) -
               ab * ab / (aa * bb);
    }
};

/// Pairs of derivatives along an axis that lie (right, down) apart.
PairMoments pairsOf(const PlaneView& plane, bool along, int right, int down) {
    const int dx = along ? 1 : 0, dy = along ? 0 : 1;
    const auto derivative = [&](int x, int y) {
        return static_cast<double>(plane(x + dx, y + dy)) - plane(x, y);
    };
    PairMoments moments;
    for (int y = 0; y + dy + down < plane.height; ++y)
        for (int x = 0; x + dx + right < plane.width; ++x)
            moments.add(derivative(x, y), derivative(x + right, y + down));
    return moments;
}

/// The distance at which γ falls below kAlike in a direction, at most half of the shorter side.
double reachIn(const Correlation& correlation, double angle) {
    const double end = correlation.size().shorterSide() / 2.0 - 1;
    double r = kStep;
    while (r < end &&
           correlation.between(r * std::cos(angle), r * std::sin(angle)) >= TextureCharacter::kAlike)
        r += kStep;
    return r;
}

void measureReach(const Correlation& correlation, double scale, TextureCharacter& character) {
    character.shortest = character.longest = scale * reachIn(correlation, 0);
    for (int i = 1; i < kDirections; ++i) {
        const double reach = scale * reachIn(correlation, std::numbers::pi * i / kDirections);
        character.shortest = std::min(character.shortest, reach);
        character.longest = std::max(character.longest, reach);
    }
}

void measureRegularity(const LatticeAnalysis& analysis, double scale, TextureCharacter& character) {
    if (analysis.candidates.empty())
        return;
    const Lattice lattice = analysis.candidates.front().lattice;
    if (analysis.correlation.size().empty() || lattice.keepsOrder(analysis.correlation.size()))
        return;
    character.regularity = analysis.confidence;
    character.rowsOnly = lattice.rowsOnly();
    character.period =
        scale * (character.rowsOnly ? lattice.area() : std::min(lattice.v1.length(), lattice.v2.length()));
}

} // namespace

double clustering(const ImageView& image) {
    constexpr int kScales = 3, kApart = 3;
    double sum = 0, weights = 0;
    Image coarser;
    ImageView view = image;
    for (int scale = 0; scale < kScales && view.size().shorterSide() > 2 * kApart; ++scale) {
        for (int c = 0; c < view.channels; ++c)
            for (const bool along : {true, false})
                for (const bool right : {true, false}) {
                    const PairMoments pairs =
                        pairsOf(view.plane(c), along, right ? kApart : 0, right ? 0 : kApart);
                    const double weight = pairs.aa / pairs.count;
                    sum += weight * pairs.excess();
                    weights += weight;
                }
        coarser = halved(view);
        view = coarser.view();
    }
    return weights > 0 ? sum / weights : 0;
}

TextureCharacter characterOf(const ImageView& exemplar, const std::function<void()>& check) {
    TextureCharacter character;
    character.size = exemplar.size();
    Image smaller;
    ImageView seen = exemplar;
    const int count = halvings(exemplar.size());
    for (int i = 0; i < count; ++i) {
        smaller = halved(seen, check);
        seen = smaller.view();
    }
    const double scale = std::ldexp(1.0, count);
    const LatticeAnalysis analysis = analyzeLattice(seen, check);
    measureRegularity(analysis, scale, character);
    measureReach(analysis.correlation, scale, character);
    character.grain = std::clamp(1 - clustering(seen) / kEdgy, 0.0, 1.0);
    return character;
}

std::uint64_t characterBytesFor(Size exemplar, int channels) {
    const int count = halvings(exemplar);
    const Size seen{std::max(1, exemplar.width >> count), std::max(1, exemplar.height >> count)};
    const std::uint64_t halves = count > 0 ? Image::bytesFor(exemplar, channels) / 3 : 0;
    return halves + latticeBytesFor(seen, channels);
}

} // namespace texloom
