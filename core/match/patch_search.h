#pragma once

#include "core/job/random.h"
#include "core/match/patch_distances.h"
#include "core/match/patch_match.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// A patch of one of the exemplars, named by its top left pixel.
struct PatchPosition {
    int exemplar = 0, x = 0, y = 0;
};

/// Finds patches in several exemplars that fit a partly known patch: PatchDistances to each of them, and ways
/// to choose. One object serves any number of threads, each with its own Scratch.
class PatchSearch {
public:
    /// Working memory of one thread; after compute() it holds the distances.
    using Scratch = std::vector<PatchDistances::Scratch>;

    /// @param exemplars must outlive the search. @param patch side in pixels. @param check called now and
    /// then and may throw. @param balance see ContrastBalance::share.
    PatchSearch(std::vector<PatchSource> exemplars, int patch, const std::function<void()>& check,
                double balance = 0);

    int patch() const { return m_patch; }
    /// Patches that the masks allow, in all exemplars.
    std::int64_t allowed() const;
    /// The nth patch that the masks allow: exemplar by exemplar, row by row.
    PatchPosition nth(std::int64_t n) const;
    /// The patch drawn by a uniform number in [0, 1), with probabilities proportional to the exemplars'
    /// weights.
    PatchPosition drawn(double uniform) const;
    /// One of the candidates, drawn by the random number at (x, y) with probabilities proportional to the
    /// exemplars' weights.
    PatchPosition drawn(const std::vector<PatchPosition>& candidates, const Random& random, int x,
                        int y) const;
    std::vector<ImageView> pixels(std::span<const PatchPosition> positions) const {
        std::vector<ImageView> views;
        for (const PatchPosition& position : positions)
            views.push_back(pixels(position));
        return views;
    }
    ImageView pixels(const PatchPosition& position) const {
        return m_exemplars[static_cast<std::size_t>(position.exemplar)].image.crop(position.x, position.y,
                                                                                   {m_patch, m_patch});
    }

    /// See PatchDistances.
    void prepare(const Footprint& shape);
    Scratch scratch() const;
    void compute(const ImageView& known, const Footprint& shape, Scratch& scratch,
                 const std::function<void()>& check) const;

    /// Weighs the distances in `to` and adds those that another search over exemplars of the same sizes
    /// found.
    void add(const Scratch& other, double weight, Scratch& to) const;

    /// Makes patches that share pixels with one of them farther: by 1 + weight × the share of their pixels.
    void discourage(const PatchPosition& used, double weight, Scratch& scratch) const;

    /// Makes patches farther by `amount` × what `by` has for them: one image for each exemplar, with a value
    /// for each of its patches.
    void raise(const std::vector<Image>& by, double amount, Scratch& scratch) const;
    /// How far a patch is from another on these pixels on average, whatever they show: twice the variance.
    /// 0 where contrast is not balanced.
    double usualDistance(const Footprint& shape) const { return 2 * m_variance * shape.pixels(m_patch); }

    /// All patches at most (1 + tolerance) times as far as the nearest (Efros & Freeman 2001). Never empty.
    std::vector<PatchPosition> within(double tolerance, const Scratch& scratch) const;
    /// The `count` nearest patches, or all if there are fewer, by increasing distance.
    std::vector<PatchPosition> nearest(int count, const Scratch& scratch) const;

private:
    float smallest(const Scratch& scratch) const;
    double weightOf(const PatchPosition& position) const {
        return m_exemplars[static_cast<std::size_t>(position.exemplar)].weight;
    }

    std::vector<PatchSource> m_exemplars;
    int m_patch;
    float m_smallest;      ///< distances below it are raised to it
    double m_variance = 0; ///< see ContrastBalance
    std::vector<PatchDistances> m_distances;
};

} // namespace texloom
