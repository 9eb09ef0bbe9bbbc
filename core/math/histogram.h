#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// Sorts and ranks samples by radix, in pieces between which `check` is called every few milliseconds.
/// Keeps its memory from one call to the next; one object per thread.
class SampleRanks {
public:
    /// Orders the samples of a plane. Equal samples keep the order of a fixed walk that scatters them over
    /// the plane, so that giving them different values creates no ramps. At most 2^32 − 1 samples.
    void sort(const PlaneView& plane, const std::function<void()>& check);
    /// Number of samples last sorted.
    std::size_t size() const { return m_order.size(); }
    /// Index y × width + x of the sample of a rank; rank 0 is the smallest.
    std::uint32_t operator[](std::size_t rank) const { return m_order[rank]; }

    static std::uint64_t bytesFor(Size size) { return static_cast<std::uint64_t>(size.area()) * 16; }

private:
    std::vector<std::uint32_t> m_order, m_keys, m_otherOrder, m_otherKeys;
};

/// The distribution of a plane's samples, to be given to another plane.
class Histogram {
public:
    Histogram() = default;
    explicit Histogram(
        const PlaneView& plane, const std::function<void()>& check = [] {});

    /// Gives `plane` this distribution and keeps the order of its samples: the sample of rank r gets the
    /// sample of rank r here (Heeger & Bergen 1995, section 3, exact). Where the numbers of samples differ,
    /// ranks are matched by quantile with linear interpolation.
    /// @return the mean squared change of the samples.
    double match(const PlaneSpan& plane, SampleRanks& ranks, const std::function<void()>& check) const;

private:
    std::vector<float> m_sorted;
};

} // namespace texloom
