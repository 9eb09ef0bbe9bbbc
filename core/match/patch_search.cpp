#include "core/match/patch_search.h"

#include "core/base/at.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texloom {

namespace {

/// The source clamps distances below 1 on a scale of 0 to 255 (Raad & Galerne, IPOL 2017, section 3.1); here
/// on the exemplars' own range.
float smallestDistance(std::span<const PatchSource> exemplars) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const PatchSource& exemplar : exemplars) {
        const ValueRange range = valueRange(exemplar.image);
        low = std::min(low, static_cast<double>(range.smallest));
        high = std::max(high, static_cast<double>(range.largest));
    }
    const double step = (high - low) / 255;
    return static_cast<float>(step * step);
}

/// Each channel's mean over all exemplars, which distances are taken relative to.
std::vector<double> commonMeans(std::span<const PatchSource> exemplars) {
    std::vector<double> means(static_cast<std::size_t>(exemplars.front().image.channels), 0.0);
    for (const PatchSource& exemplar : exemplars) {
        const std::vector<double> own = channelMeans(exemplar.image);
        for (std::size_t c = 0; c < means.size(); ++c)
            means[c] += own[c] / static_cast<double>(exemplars.size());
    }
    return means;
}

struct Ranked {
    float distance;
    PatchPosition position;
    friend bool operator<(const Ranked& a, const Ranked& b) { return a.distance < b.distance; }
};

} // namespace

PatchSearch::PatchSearch(std::vector<PatchSource> exemplars, int patch, const std::function<void()>& check,
                         double balance)
    : m_exemplars(std::move(exemplars)), m_patch(patch), m_smallest(smallestDistance(m_exemplars)) {
    const std::vector<double> means = commonMeans(m_exemplars);
    if (balance > 0)
        m_variance = pixelVariance(m_exemplars, means, check);
    const ContrastBalance contrast{balance, m_variance};
    for (const PatchSource& exemplar : m_exemplars) {
        m_distances.emplace_back(exemplar.image, exemplar.mask, means, patch, contrast);
        check();
    }
}

std::int64_t PatchSearch::allowed() const {
    std::int64_t allowed = 0;
    for (const PatchDistances& distances : m_distances)
        allowed += distances.allowed();
    return allowed;
}

PatchPosition PatchSearch::nth(std::int64_t n) const {
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        const Size positions = m_distances[e].positions();
        for (int y = 0; y < positions.height; ++y)
            for (int x = 0; x < positions.width; ++x)
                if (m_distances[e].allows(x, y) && n-- == 0)
                    return {static_cast<int>(e), x, y};
    }
    return {};
}

PatchPosition PatchSearch::drawn(double uniform) const {
    double whole = 0;
    for (std::size_t e = 0; e < m_distances.size(); ++e)
        whole += m_exemplars[e].weight * static_cast<double>(m_distances[e].allowed());
    double left = uniform * whole;
    std::int64_t before = 0;
    for (std::size_t e = 0; e + 1 < m_distances.size(); ++e) {
        const double own = m_exemplars[e].weight * static_cast<double>(m_distances[e].allowed());
        if (left < own)
            return nth(before + static_cast<std::int64_t>(left / m_exemplars[e].weight));
        left -= own;
        before += m_distances[e].allowed();
    }
    return nth(std::min(before + static_cast<std::int64_t>(left / m_exemplars.back().weight), allowed() - 1));
}

PatchPosition PatchSearch::drawn(const std::vector<PatchPosition>& candidates, const Random& random, int x,
                                 int y) const {
    const double weight = m_exemplars.front().weight;
    const bool alike = std::all_of(m_exemplars.begin(), m_exemplars.end(),
                                   [=](const PatchSource& one) { return one.weight == weight; });
    if (alike)
        return candidates[random.below(static_cast<std::uint32_t>(candidates.size()), x, y)];
    double whole = 0;
    for (const PatchPosition& candidate : candidates)
        whole += weightOf(candidate);
    double left = random.uniform(x, y) * whole;
    for (const PatchPosition& candidate : candidates)
        if ((left -= weightOf(candidate)) < 0)
            return candidate;
    return candidates.back();
}

void PatchSearch::prepare(const Footprint& shape) {
    for (PatchDistances& distances : m_distances)
        distances.prepare(shape);
}

PatchSearch::Scratch PatchSearch::scratch() const {
    Scratch scratch;
    for (const PatchDistances& distances : m_distances)
        scratch.push_back(distances.scratch());
    return scratch;
}

void PatchSearch::compute(const ImageView& known, const Footprint& shape, Scratch& scratch,
                          const std::function<void()>& check) const {
    for (std::size_t e = 0; e < m_distances.size(); ++e)
        m_distances[e].compute(known, shape, m_smallest, scratch[e], check);
}

void PatchSearch::add(const Scratch& other, double weight, Scratch& to) const {
    const auto factor = static_cast<float>(weight);
    for (std::size_t e = 0; e < m_distances.size(); ++e)
        for (int y = 0; y < m_distances[e].positions().height; ++y) {
            const float* from = m_distances[e].distanceRow(other[e], y);
            float* row = m_distances[e].distanceRow(to[e], y);
            const int width = m_distances[e].positions().width;
            for (int x = 0; x < width; ++x)
                row[x] = factor * row[x] + from[x];
            to[e].rowMinima[static_cast<std::size_t>(y)] = *std::min_element(row, row + width);
        }
}

void PatchSearch::discourage(const PatchPosition& used, double weight, Scratch& scratch) const {
    const auto e = static_cast<std::size_t>(used.exemplar);
    const Size positions = m_distances[e].positions();
    const int left = std::max(0, used.x - m_patch + 1), right = std::min(positions.width, used.x + m_patch);
    const int top = std::max(0, used.y - m_patch + 1), bottom = std::min(positions.height, used.y + m_patch);
    std::vector<float> shared; // columns of the patch
    for (int x = left; x < right; ++x)
        shared.push_back(static_cast<float>(m_patch - std::abs(x - used.x)));
    const auto count = static_cast<std::ptrdiff_t>(shared.size());
    const float* const columns = shared.data(); // a plain pointer, so that the loop vectorises
    for (int y = top; y < bottom; ++y) {
        float* const from = m_distances[e].distanceRow(scratch[e], y) + left;
        const auto share =
            static_cast<float>(weight * (m_patch - std::abs(y - used.y)) / (1.0 * m_patch * m_patch));
        for (std::ptrdiff_t i = 0; i < count; ++i)
            from[i] *= 1 + share * columns[i];
    }
}

void PatchSearch::raise(const std::vector<Image>& by, double amount, Scratch& scratch) const {
    const auto factor = static_cast<float>(amount);
    for (std::size_t e = 0; e < m_distances.size(); ++e)
        for (int y = 0; y < m_distances[e].positions().height; ++y) {
            const float* const more = by[e].view().plane(0).row(y);
            float* const row = m_distances[e].distanceRow(scratch[e], y);
            for (int x = 0; x < m_distances[e].positions().width; ++x)
                row[x] += factor * more[x];
        }
}

float PatchSearch::smallest(const Scratch& scratch) const {
    float found = HUGE_VALF;
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        const Size positions = m_distances[e].positions();
        for (int y = 0; y < positions.height; ++y) {
            if (scratch[e].rowMinima[at(y)] >= found)
                continue;
            const float* row = m_distances[e].distanceRow(scratch[e], y);
            found = std::min(found, *std::min_element(row, row + positions.width));
        }
    }
    return found;
}

std::vector<PatchPosition> PatchSearch::within(double tolerance, const Scratch& scratch) const {
    const float limit = smallest(scratch) * static_cast<float>(1 + tolerance);
    std::vector<PatchPosition> candidates;
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        const Size positions = m_distances[e].positions();
        for (int y = 0; y < positions.height; ++y) {
            if (scratch[e].rowMinima[static_cast<std::size_t>(y)] > limit)
                continue;
            const float* row = m_distances[e].distanceRow(scratch[e], y);
            for (int x = 0; x < positions.width; ++x)
                if (row[x] <= limit)
                    candidates.push_back({static_cast<int>(e), x, y});
        }
    }
    return candidates;
}

std::vector<PatchPosition> PatchSearch::nearest(int count, const Scratch& scratch) const {
    // A heap of the nearest so far with the farthest of them on top; of equal ones the first is kept.
    std::vector<Ranked> heap;
    const auto wanted = static_cast<std::size_t>(count);
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        const Size positions = m_distances[e].positions();
        for (int y = 0; y < positions.height; ++y) {
            float limit = heap.size() < wanted ? HUGE_VALF : heap.front().distance;
            if (scratch[e].rowMinima[static_cast<std::size_t>(y)] >= limit)
                continue;
            const float* row = m_distances[e].distanceRow(scratch[e], y);
            for (int x = 0; x < positions.width; ++x) {
                if (row[x] >= limit)
                    continue;
                if (heap.size() == wanted) {
                    std::pop_heap(heap.begin(), heap.end());
                    heap.pop_back();
                }
                heap.push_back({row[x], {static_cast<int>(e), x, y}});
                std::push_heap(heap.begin(), heap.end());
                if (heap.size() == wanted)
                    limit = heap.front().distance;
            }
        }
    }
    std::sort_heap(heap.begin(), heap.end());
    std::vector<PatchPosition> found;
    for (const Ranked& ranked : heap)
        found.push_back(ranked.position);
    return found;
}

} // namespace texloom
