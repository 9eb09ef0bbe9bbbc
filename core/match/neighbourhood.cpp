#include "core/match/neighbourhood.h"

#include "core/base/wide_vectors.h"
#include "core/image/mirror.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace texloom {

Neighbourhood::Neighbourhood(const std::vector<NeighbourhoodPart>& parts, const std::vector<int>& pixels) {
    const bool weighs = std::any_of(parts.begin(), parts.end(),
                                    [](const NeighbourhoodPart& part) { return !part.weights.empty(); });
    for (std::size_t p = 0; p < parts.size(); ++p) {
        std::size_t at = 0;
        for (const PixelRun& run : parts[p].runs) {
            const int floats = run.count * pixels[p];
            const int margin = parts[p].margin;
            m_stretches.push_back({p, parts[p].halved ? 1 : 0, margin, run.dx + margin, run.dy + margin,
                                   m_length, floats, pixels[p]});
            m_length += floats;
            for (int i = 0; weighs && i < floats; ++i)
                m_weights.push_back(parts[p].weights.empty()
                                        ? 1
                                        : parts[p].weights[at + static_cast<std::size_t>(i / pixels[p])]);
            at += static_cast<std::size_t>(run.count);
        }
    }
}

bool Neighbourhood::within(const Pictures& pictures, int x, int y) const {
    return std::all_of(m_stretches.begin(), m_stretches.end(), [&](const Stretch& stretch) {
        const Size size = pictures[stretch.part]->size;
        const int left = (x >> stretch.halvings) + stretch.left, top = (y >> stretch.halvings) + stretch.top;
        return left >= 0 && top >= 0 && top < size.height &&
               left + stretch.floats / stretch.pixel <= size.width;
    });
}

bool Neighbourhood::clear(const PlaneView& mask, int x, int y) const {
    if (mask(x, y) == 0)
        return false;
    const auto shown = [&](int left, int top, int width, int height) {
        for (int row = top; row < top + height; ++row)
            if (std::any_of(mask.row(row) + left, mask.row(row) + left + width,
                            [](float one) { return one == 0; }))
                return false;
        return true;
    };
    return std::all_of(m_stretches.begin(), m_stretches.end(), [&](const Stretch& stretch) {
        const int count = stretch.floats / stretch.pixel;
        if (stretch.margin > 0)
            return true;
        if (stretch.halvings == 0)
            return shown(x + stretch.left, y + stretch.top, count, 1);
        // A pixel of the coarser scale is made of two by two.
        return shown(2 * (x / 2 + stretch.left), 2 * (y / 2 + stretch.top), 2 * count, 2);
    });
}

void Neighbourhood::gather(const Pictures& pictures, int x, int y, float* to) const {
    for (const Stretch& stretch : m_stretches) {
        const Interleaved& picture = *pictures[stretch.part];
        const Size size = picture.size;
        const int count = stretch.floats / stretch.pixel;
        const int row = repeated((y >> stretch.halvings) + stretch.top, size.height);
        int column = repeated((x >> stretch.halvings) + stretch.left, size.width);
        for (int done = 0; done < count; column = 0) {
            const int straight = std::min(count - done, size.width - column);
            to = std::copy_n(picture.at(column, row), straight * stretch.pixel, to);
            done += straight;
        }
    }
}

std::vector<int> Neighbourhood::nearestFloats(int count) const {
    std::vector<int> chosen(static_cast<std::size_t>(m_length));
    std::iota(chosen.begin(), chosen.end(), 0);
    if (count >= m_length)
        return chosen;
    std::vector<int> apart(chosen.size());
    for (const Stretch& stretch : m_stretches)
        for (int i = 0; i < stretch.floats; ++i) {
            const int dx = (stretch.left - stretch.margin + i / stretch.pixel) << stretch.halvings,
                      dy = (stretch.top - stretch.margin) << stretch.halvings;
            apart[static_cast<std::size_t>(stretch.begin) + static_cast<std::size_t>(i)] = dx * dx + dy * dy;
        }
    std::stable_sort(chosen.begin(), chosen.end(), [&](int a, int b) {
        return apart[static_cast<std::size_t>(a)] < apart[static_cast<std::size_t>(b)];
    });
    chosen.resize(static_cast<std::size_t>(count));
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

NeighbourhoodSet::NeighbourhoodSet(Neighbourhood neighbourhood, std::vector<NeighbourhoodSource> sources,
                                   const std::function<void()>& check)
    : m_neighbourhood(std::move(neighbourhood)), m_exemplars(std::move(sources)) {
    for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
        const NeighbourhoodSource& exemplar = m_exemplars[e];
        const Size size = exemplar.pictures.front()->size;
        auto& has = m_has.emplace_back(static_cast<std::size_t>(size.area()), std::uint8_t{0});
        m_firsts.push_back(m_sources.size());
        std::size_t at = 0;
        for (int y = 0; y < size.height; ++y) {
            check();
            for (int x = 0; x < size.width; ++x, ++at) {
                if (!m_neighbourhood.within(exemplar.pictures, x, y) ||
                    (exemplar.mask.data && !m_neighbourhood.clear(exemplar.mask, x, y)))
                    continue;
                has[at] = 1;
                m_sources.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                     static_cast<std::uint16_t>(e)});
            }
        }
    }
    m_firsts.push_back(m_sources.size());
}

const Source& NeighbourhoodSet::drawn(double uniform) const {
    double whole = 0;
    for (std::size_t e = 0; e < m_exemplars.size(); ++e)
        whole += m_exemplars[e].weight * static_cast<double>(m_firsts[e + 1] - m_firsts[e]);
    double left = uniform * whole;
    std::size_t at = 0;
    for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
        const auto count = static_cast<double>(m_firsts[e + 1] - m_firsts[e]);
        const double own = m_exemplars[e].weight * count;
        at = m_firsts[e] + static_cast<std::size_t>(std::clamp(left / m_exemplars[e].weight, 0.0, count));
        if (left < own)
            break;
        left -= own;
    }
    return m_sources[std::min(at, m_sources.size() - 1)];
}

namespace {

/// Of the sources from `first` on, the first one that is nearest; `limit` becomes its distance.
TEXLOOM_WIDE_VECTORS std::size_t nearestOf(const NeighbourhoodSet& set, const float* wanted,
                                           std::size_t first, std::size_t end, float& limit, bool& met) {
    std::size_t best = end;
    for (std::size_t i = first; i < end; ++i) {
        const float found = set.distance(wanted, set.sources()[i], limit);
        // A limit that nobody was found for yet is met by the first one that keeps it.
        if (found < limit || (found == limit && !met)) {
            limit = found;
            best = i;
            met = true;
        }
    }
    return best;
}

} // namespace

Source NeighbourhoodSet::nearest(const float* wanted, float limit, const std::function<void()>& check) const {
    constexpr std::size_t kBlock = 16384;
    std::size_t best = 0;
    bool met = false;
    for (std::size_t first = 0; first < m_sources.size(); first += kBlock) {
        check();
        const std::size_t end = std::min(m_sources.size(), first + kBlock);
        const std::size_t found = nearestOf(*this, wanted, first, end, limit, met);
        if (found < end)
            best = found;
    }
    return m_sources[best];
}

std::uint64_t NeighbourhoodSet::bytesFor(std::span<const Size> exemplars) {
    // A list that grows may take twice its room.
    std::uint64_t bytes = 0;
    for (const Size& size : exemplars)
        bytes += static_cast<std::uint64_t>(size.area()) * (1 + 3 * sizeof(Source));
    return bytes;
}

} // namespace texloom
