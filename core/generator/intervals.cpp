#include "core/generator/intervals.h"

#include "core/base/at.h"

namespace texloom {

namespace {

constexpr int kReach = 2; ///< what a block loses at either side

Interval grown(const Interval& interval, int by) {
    return {interval.begin - by, interval.end + by};
}

std::vector<int> placesOf(std::int64_t begin, int length, std::int64_t coarseBegin, int period) {
    std::vector<int> places;
    for (int i = 0; i < length; ++i)
        places.push_back(static_cast<int>(coarser(begin + i, period) - coarseBegin));
    return places;
}

} // namespace

std::int64_t coarser(std::int64_t place, int period) {
    if (period == 0)
        return place >> 1;
    std::int64_t round = place / period, rest = place % period;
    if (rest < 0) {
        --round;
        rest += period;
    }
    return round * periodAt(period, 1) + (rest >> 1);
}

std::vector<ScaleIntervals> scaleIntervals(Interval wanted, int coarsest, int period) {
    std::vector<ScaleIntervals> all;
    for (int k = 0; k <= coarsest; ++k) {
        const bool last = k == coarsest;
        all.push_back(
            {wanted, last ? Interval{} : grown(wanted, kReach), grown(wanted, last ? kReach : 2 * kReach)});
        const int around = periodAt(period, k);
        wanted = {coarser(wanted.begin - kReach, around), coarser(wanted.end + kReach - 1, around) + 1};
    }
    return all;
}

std::vector<ScaleBoxes> scaleBoxes(const Box& wanted, int coarsest, bool flat, const VolumeSize& period) {
    const auto x = scaleIntervals({wanted.x, wanted.endX()}, coarsest, period.width);
    const auto y = scaleIntervals({wanted.y, wanted.endY()}, coarsest, period.height);
    const auto z = scaleIntervals({wanted.z, wanted.endZ()}, coarsest, period.depth);
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

CoarserPlaces::CoarserPlaces(const Box& fine, const Box& coarse, bool flat, const VolumeSize& period)
    : x(placesOf(fine.x, fine.size.width, coarse.x, period.width)),
      y(placesOf(fine.y, fine.size.height, coarse.y, period.height)) {
    if (!flat)
        z = placesOf(fine.z, fine.size.depth, coarse.z, period.depth);
    for (int i = 0; flat && i < fine.size.depth; ++i)
        z.push_back(i);
}

} // namespace texloom
