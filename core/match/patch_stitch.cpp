#include "core/match/patch_stitch.h"

#include "core/base/text.h"
#include "core/match/boundary_cut.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

/// Half the width over which a smoothed cut blends.
constexpr int kSoftness = 3;

void measureError(const ImageView& old, const ImageView& fresh, const Overlap& overlap, PlaneSpan error) {
    const int patch = fresh.width;
    for (int y = 0; y < patch; ++y) {
        float* row = error.row(y);
        for (int x = 0; x < patch; ++x) {
            row[x] = 0;
            if (!overlap.contains(x, y, patch))
                continue;
            for (int c = 0; c < fresh.channels; ++c) {
                const float difference = old(x, y, c) - fresh(x, y, c);
                row[x] += difference * difference;
            }
        }
    }
}

/// The mean over a square, by rows and then by columns.
void soften(const BoundaryCut& cut, const Overlap& overlap, int reach, PlaneSpan rowSums, PlaneSpan weight) {
    const int patch = cut.patch;
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x) {
            rowSums(x, y) = 0;
            for (int dx = -reach; dx <= reach; ++dx)
                rowSums(x, y) += cut.keeps(std::clamp(x + dx, 0, patch - 1), y) ? 1.0F : 0.0F;
        }
    const auto area = static_cast<float>((2 * reach + 1) * (2 * reach + 1));
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x) {
            float kept = 0;
            for (int dy = -reach; dy <= reach; ++dy)
                kept += rowSums(x, std::clamp(y + dy, 0, patch - 1));
            weight(x, y) = overlap.contains(x, y, patch) ? kept / area : 0.0F;
        }
}

/// The old pixel's share at distance `at` from a border that overlaps by `width`.
float rampAt(int at, int width) {
    if (at >= width)
        return 0;
    return width > 1 ? 1 - static_cast<float>(at) / static_cast<float>(width - 1) : 0.5F;
}

std::array<int, 4> keyOf(const Overlap& overlap) {
    return {overlap.left, overlap.top, overlap.right, overlap.bottom};
}

} // namespace

double cutWeights(const ImageView& old, const ImageView& fresh, const Overlap& overlap, int softness,
                  PlaneSpan error, PlaneSpan weight) {
    measureError(old, fresh, overlap, error);
    const BoundaryCut cut = minimumErrorCut(error, overlap);
    // The error is no longer needed, so its memory is reused.
    soften(cut, overlap, softness, error, weight);
    return cut.cost;
}

void averageWeights(const Overlap& overlap, PlaneSpan weight) {
    for (int y = 0; y < weight.height; ++y)
        for (int x = 0; x < weight.width; ++x)
            weight(x, y) = overlap.contains(x, y, weight.width) ? 0.5F : 0.0F;
}

void rampWeights(const Overlap& overlap, PlaneSpan weight) {
    const int last = weight.width - 1;
    for (int y = 0; y < weight.height; ++y)
        for (int x = 0; x < weight.width; ++x)
            weight(x, y) = 1 - (1 - rampAt(x, overlap.left)) * (1 - rampAt(y, overlap.top)) *
                                   (1 - rampAt(last - x, overlap.right)) *
                                   (1 - rampAt(last - y, overlap.bottom));
}

void mixPatches(const ImageView& old, const PlaneView& weight, Image& fresh) {
    for (int c = 0; c < fresh.channels(); ++c)
        for (int y = 0; y < fresh.height(); ++y)
            for (int x = 0; x < fresh.width(); ++x)
                if (weight(x, y) == 1)
                    fresh(x, y, c) = old(x, y, c);
                else if (weight(x, y) > 0)
                    fresh(x, y, c) += weight(x, y) * (old(x, y, c) - fresh(x, y, c));
}

std::vector<Choice> patchStitchChoices() {
    return {{"cut", TR("Minimum-error cut")}, {"smooth-cut", TR("Smoothed cut")},
            {"average", TR("Average")},       {"none", TR("None")},
            {"poisson", TR("Poisson")},       {"midway", TR("Midway")},
            {"feather", TR("Feather")}};
}

PatchStitcher::PatchStitcher(PatchStitch stitch, int patch, const MidwayOptions& midway)
    : m_stitch(stitch), m_patch(patch), m_midway(midway) {}

void PatchStitcher::prepare(const Overlap& overlap) {
    const auto [at, missing] =
        blends() ? m_bands.try_emplace(keyOf(overlap)) : std::pair(m_bands.end(), false);
    if (!missing)
        return;
    int narrowest = m_patch;
    for (const int width : {overlap.left, overlap.top, overlap.right, overlap.bottom})
        narrowest = width > 0 ? std::min(narrowest, width) : narrowest;
    // The outermost pixels of the overlap stay as they are.
    const int width = (narrowest - 1) / 2;
    if (width < 1)
        return;
    for (BlendCurve& curve : BlendCurve::around(overlap, m_patch)) {
        BlendBand& band = at->second.emplace_back(std::move(curve), Size{m_patch, m_patch}, width);
        if (m_stitch == PatchStitch::Poisson)
            band.preparePoisson();
    }
}

void PatchStitcher::blend(const ImageView& old, const Overlap& overlap, Image& fresh) const {
    for (const BlendBand& band : m_bands.at(keyOf(overlap))) {
        Image joined(old);
        if (m_stitch == PatchStitch::Poisson)
            band.poisson(old, fresh, joined);
        else
            band.midway(old, fresh, m_midway, joined);
        fresh = std::move(joined);
    }
}

PatchStitcher::Scratch PatchStitcher::scratch() const {
    return {Image({m_patch, m_patch}, 1), Image({m_patch, m_patch}, 1)};
}

void PatchStitcher::join(const ImageView& old, const Overlap& overlap, Image& fresh, Scratch& scratch) const {
    if (m_stitch == PatchStitch::None || overlap.none())
        return;
    if (blends())
        return blend(old, overlap, fresh);
    const PlaneSpan weight = scratch.weight.plane(0);
    if (m_stitch == PatchStitch::Average || m_stitch == PatchStitch::Feather)
        shares(overlap, weight);
    else
        cutWeights(old, fresh, overlap, m_stitch == PatchStitch::SmoothCut ? kSoftness : 0,
                   scratch.error.plane(0), weight);
    mixPatches(old, weight, fresh);
}

void PatchStitcher::shares(const Overlap& overlap, PlaneSpan weight) const {
    const bool closes = overlap.right > 0 || overlap.bottom > 0;
    if (m_stitch == PatchStitch::Feather || (m_stitch == PatchStitch::Average && closes))
        return rampWeights(overlap, weight);
    if (m_stitch == PatchStitch::Average)
        return averageWeights(overlap, weight);
    for (int y = 0; y < weight.height; ++y)
        std::fill_n(weight.row(y), weight.width, 0.0F);
    if (!blends() || overlap.none())
        return;
    for (const BlendBand& band : m_bands.at(keyOf(overlap)))
        band.markFirst(weight);
}

std::uint64_t PatchStitcher::bytesFor(PatchStitch stitch, int patch, int overlap, int overlaps, int threads) {
    // Of a pixel of a band, and of one for which Poisson's equation is factored.
    constexpr std::uint64_t kPixel = 64, kEquation = 800;
    // What sorting and moving the mass of one patch's lines takes.
    constexpr std::uint64_t kLines = 4ULL << 20;
    const auto side = static_cast<std::uint64_t>(patch);
    if (stitch != PatchStitch::Poisson && stitch != PatchStitch::Midway)
        return 0;
    const std::uint64_t band = 4 * side * static_cast<std::uint64_t>(overlap);
    const std::uint64_t pixel = kPixel + (stitch == PatchStitch::Poisson ? kEquation : 0);
    return static_cast<std::uint64_t>(overlaps) * (band * pixel + side * 24) +
           static_cast<std::uint64_t>(threads) * (kLines + side * side * 64);
}

} // namespace texloom
