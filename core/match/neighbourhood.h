#pragma once

#include "core/image/position_map.h"
#include "core/match/interleaved.h"
#include "core/match/pixel_runs.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// What a neighbourhood shows of one picture.
struct NeighbourhoodPart {
    PixelRuns runs;
    /// The picture is that of the next coarser scale: the pixels lie about (x / 2, y / 2).
    bool halved = false;
    /// How much each pixel of the runs counts, in their order; all 1 if empty.
    std::vector<float> weights;
    /// So many pixels does the picture go on beyond each border of its scale. What a part with a margin shows
    /// need not lie within the scale, nor be clear of the mask.
    int margin = 0;
};

/// The pixels about one pixel that are compared, in one or more pictures, as one vector of floats: the causal
/// half of a square on one scale with a square of the coarser scale, say.
class Neighbourhood {
public:
    /// One for each part, of the size of its scale and the part's margin.
    using Pictures = std::span<const Interleaved* const>;

    /// @param pixels floats of a pixel in the picture of each part.
    Neighbourhood(const std::vector<NeighbourhoodPart>& parts, const std::vector<int>& pixels);

    /// Floats of a vector.
    int length() const { return m_length; }
    /// Whether all that the neighbourhood of (x, y) shows lies within the pictures.
    bool within(const Pictures& pictures, int x, int y) const;
    /// Whether the mask of the first part's scale is nowhere 0 in the neighbourhood, nor at its centre.
    bool clear(const PlaneView& mask, int x, int y) const;
    /// The neighbourhood of (x, y) as a vector; pictures without a margin go on round their borders.
    /// @param to length() floats.
    void gather(const Pictures& pictures, int x, int y, float* to) const;
    /// Sum of squared differences between a vector and the neighbourhood of (x, y), which lies within the
    /// pictures; given up once it is above `limit`.
    float distance(const float* wanted, const Pictures& pictures, int x, int y, float limit) const {
        float sum = 0;
        for (const Stretch& stretch : m_stretches) {
            const float* found = pictures[stretch.part]->at((x >> stretch.halvings) + stretch.left,
                                                            (y >> stretch.halvings) + stretch.top);
            sum += m_weights.empty() ? squares(wanted + stretch.begin, found, stretch.floats)
                                     : squares(wanted + stretch.begin, found, stretch.floats,
                                               m_weights.data() + stretch.begin);
            if (sum > limit)
                break;
        }
        return sum;
    }

    /// How much each float counts; empty if all count alike.
    const std::vector<float>& weights() const { return m_weights; }
    /// The floats of a vector that lie nearest to the centre, at most `count` of them, in rising order.
    std::vector<int> nearestFloats(int count) const;

private:
    /// A run in floats.
    struct Stretch {
        std::size_t part;
        int halvings, margin;
        int left, top; ///< of its first pixel in a picture, relative to the centre's place without a margin
        int begin, floats, pixel;
    };
    /// Sums of eight lanes, which vectorise and give the same bits at any width of vectors.
    static constexpr int kLanes = 8;
    static float total(const float* lanes) {
        return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) +
               ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
    }
    static float squares(const float* a, const float* b, int count) {
        float lanes[kLanes] = {};
        int i = 0;
        for (; i + kLanes <= count; i += kLanes)
            for (int lane = 0; lane < kLanes; ++lane)
                lanes[lane] += (a[i + lane] - b[i + lane]) * (a[i + lane] - b[i + lane]);
        for (int lane = 0; i < count; ++i, ++lane)
            lanes[lane] += (a[i] - b[i]) * (a[i] - b[i]);
        return total(lanes);
    }
    static float squares(const float* a, const float* b, int count, const float* weights) {
        float lanes[kLanes] = {};
        int i = 0;
        for (; i + kLanes <= count; i += kLanes)
            for (int lane = 0; lane < kLanes; ++lane)
                lanes[lane] += weights[i + lane] * (a[i + lane] - b[i + lane]) * (a[i + lane] - b[i + lane]);
        for (int lane = 0; i < count; ++i, ++lane)
            lanes[lane] += weights[i] * (a[i] - b[i]) * (a[i] - b[i]);
        return total(lanes);
    }

    std::vector<Stretch> m_stretches;
    std::vector<float> m_weights; ///< of each float; empty if all are 1
    int m_length = 0;
};

/// An exemplar's pictures, one for each part of a neighbourhood, and what of it may be found.
struct NeighbourhoodSource {
    std::vector<const Interleaved*> pictures;
    PlaneView mask; ///< of the size of the first picture, or {}
    double weight = 1;
};

/// The pixels of exemplars whose neighbourhoods may be found: those that lie within the exemplar and show
/// nothing that its mask hides.
class NeighbourhoodSet {
public:
    /// @param sources their pictures must outlive the set. @param check called for every row; may throw.
    NeighbourhoodSet(Neighbourhood neighbourhood, std::vector<NeighbourhoodSource> sources,
                     const std::function<void()>& check);

    const Neighbourhood& neighbourhood() const { return m_neighbourhood; }
    const std::vector<NeighbourhoodSource>& exemplars() const { return m_exemplars; }
    /// All of them, in order of reading.
    const std::vector<Source>& sources() const { return m_sources; }
    bool has(int x, int y, int exemplar) const {
        const auto& own = m_has[static_cast<std::size_t>(exemplar)];
        const Size size = m_exemplars[static_cast<std::size_t>(exemplar)].pictures.front()->size;
        return x >= 0 && y >= 0 && x < size.width && y < size.height &&
               own[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                   static_cast<std::size_t>(x)] != 0;
    }
    /// The one that a uniform number in [0, 1) draws, each as likely as its exemplar weighs.
    const Source& drawn(double uniform) const;
    float distance(const float* wanted, const Source& source, float limit) const {
        return m_neighbourhood.distance(wanted, m_exemplars[source.exemplar].pictures, source.x, source.y,
                                        limit);
    }
    /// The nearest of all, of equal ones the first in order of reading. @param limit a bound that some of
    /// them keep. @param check called every few milliseconds; may throw.
    Source nearest(const float* wanted, float limit, const std::function<void()>& check) const;

    /// Bytes that a set takes.
    static std::uint64_t bytesFor(std::span<const Size> exemplars);

private:
    Neighbourhood m_neighbourhood;
    std::vector<NeighbourhoodSource> m_exemplars;
    std::vector<Source> m_sources;
    std::vector<std::vector<std::uint8_t>> m_has;
    std::vector<std::size_t> m_firsts; ///< where each exemplar's sources begin, and the end
};

} // namespace texloom
