#pragma once

#include "core/image/image.h"
#include "core/match/patch_distances.h"
#include "core/methods/near_regular/settings.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace texloom::near_regular {

/// A pixel of the exemplar.
struct Point {
    int x = 0, y = 0;
};

/// Rates all patches of an exemplar by how well they fit a border: by squared differences (eq. 4.4 and 4.5),
/// or by γ with the hole that the border encloses left out of all sums (section 4.2.2). May be used by any
/// number of threads, each with its own Scratch.
class BorderMatch {
public:
    using Scratch = PatchDistances::Scratch;

    /// @param mask one channel of the exemplar's size, or {}: patches with a pixel where it is 0 are never
    /// chosen.
    BorderMatch(const ImageView& exemplar, const PlaneView& mask, int patch, Match match);

    /// Whether the mask allows a patch, and how many it allows.
    bool allows(int x, int y) const { return m_distances.allows(x, y); }
    std::int64_t allowed() const { return m_distances.allowed(); }

    /// Makes the tables for a shape of border; not to be called while other threads choose().
    void prepare(const Overlap& border);
    Scratch scratch() const { return m_distances.scratch(); }

    /// The patch that fits best of those up to `tolerance` pixels from one of `points`; of all if there are
    /// no points. @param known a patch whose border counts. @param check called every few milliseconds; may
    /// throw.
    Point choose(const ImageView& known, const Overlap& border, const std::vector<Point>& points,
                 int tolerance, Scratch& scratch, const std::function<void()>& check) const;

    static std::uint64_t bytesFor(Size exemplar, int channels, int shapes, Match match);

private:
    /// Sums over the border at each position of each channel: its values, and the root of N S_f² − (S_f)².
    struct Sums {
        Overlap border;
        std::vector<Image> values, spreads;
        Image squares; ///< S_f² over all channels
        double count = 0;
    };
    void toCorrelation(const ImageView& known, const Overlap& border, Scratch& scratch) const;

    ImageView m_exemplar;
    int m_patch;
    Match m_match;
    std::vector<double> m_means;
    PatchDistances m_distances;
    std::vector<Sums> m_sums;
};

} // namespace texloom::near_regular
