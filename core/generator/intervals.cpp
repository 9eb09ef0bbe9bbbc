#include "core/generator/intervals.h"

#include "core/base/at.h"

namespace texloom {

namespace {

constexpr int kReach = 2; ///< what a block loses at either side

/// ⌊n / 2⌋, of negative numbers, too.
std::int64_t halfOf(std::int64_t n) {
    return n >> 1;
}

Interval grown(const Interval& interval, int by) {
    return {interval.begin - by, interval.end + by};
}

} // namespace

std::vector<ScaleIntervals> scaleIntervals(Interval wanted, int coarsest) {
    std::vector<ScaleIntervals> all;
    for (int k = 0; k <= coarsest; ++k) {
        const bool last = k == coarsest;
        all.push_back(
            {wanted, last ? Interval{} : grown(wanted, kReach), grown(wanted, last ? kReach : 2 * kReach)});
        wanted = {halfOf(wanted.begin - kReach), halfOf(wanted.end + kReach - 1) + 1};
    }
    return all;
}

std::vector<ScaleBoxes> scaleBoxes(const Box& wanted, int coarsest, bool flat) {
    const auto x = scaleIntervals({wanted.x, wanted.endX()}, coarsest);
    const auto y = scaleIntervals({wanted.y, wanted.endY()}, coarsest);
    const auto z = scaleIntervals({wanted.z, wanted.endZ()}, coarsest);
    std::vector<ScaleBoxes> all;
    for (int k = 0; k <= coarsest; ++k) {
        const auto box = [&](Interval ScaleIntervals::*part) {
            const Interval& u = x[at(k)].*part;
            const Interval& v = y[at(k)].*part;
            const Interval w = flat ? Interval{wanted.z, wanted.endZ()} : z[at(k)].*part;
            return Box{u.begin, v.begin, w.begin, {u.length(), v.length(), w.length()}};
        };
        all.push_back(
            {box(&ScaleIntervals::output), box(&ScaleIntervals::joined), box(&ScaleIntervals::noise)});
    }
    return all;
}

} // namespace texloom
