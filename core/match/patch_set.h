#pragma once

#include "core/image/position_map.h"
#include "core/match/interleaved.h"
#include "core/match/patch_match.h"

#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// A short descriptor of a patch: its coordinates along the principal axes of the patches' means over 8 × 8
/// blocks. Squared distances of descriptors are lower bounds of those of the patches.
class PatchBasis {
public:
    static constexpr int kAxes = 16;
    using Descriptor = std::array<float, kAxes>;

    /// Learns the axes. @param channels in the images; the first three count. @param check may throw.
    PatchBasis(std::span<const Interleaved* const> images, int channels, int patch,
               const std::function<void()>& check);

    int patch() const { return m_patch; }
    /// @param pixels where the patch begins, a row of it every `stride` floats.
    Descriptor describe(const float* pixels, std::ptrdiff_t stride) const;

private:
    void blocks(const float* pixels, std::ptrdiff_t stride, float* means) const;

    int m_patch, m_pixel, m_channels;
    int m_blocks;              ///< along a side
    std::vector<float> m_axes; ///< kAxes for each block mean
};

/// Patches of images, searched exactly: in order of the first coordinate, outwards from that of the query,
/// skipping all that the descriptors rule out.
class PatchSet {
public:
    /// @param images must outlive the set. @param has says which patches, by top left pixel, are in it.
    /// @param check called every few milliseconds; may throw.
    PatchSet(std::vector<const Interleaved*> images, const PatchBasis& basis, int stride,
             const std::function<bool(const Source&)>& has, const std::function<void()>& check);

    int count() const { return static_cast<int>(m_entries.size()); }
    /// Of the nth patch, in reading order.
    const std::vector<Source>& sources() const { return m_sources; }

    /// Adds this to the distance, as a norm, of the nth patch from now on; empty for none. Not negative.
    void setPenalties(std::vector<float> penalties);
    /// The same for one patch, where there are penalties.
    void setPenalty(int number, float penalty) { m_penalties[static_cast<std::size_t>(number)] = penalty; }

    /// The nearest patch, penalties included; of equal ones the first in reading order.
    /// @param pixels where the query patch begins, a row of it every `stride` floats.
    /// @param hint one of the set's patches that may be near, or an invalid source.
    /// @return distance without the penalty.
    PatchMatch nearest(const float* pixels, std::ptrdiff_t stride, const PatchMatch& hint) const;

private:
    struct Entry {
        PatchBasis::Descriptor descriptor;
        int number;
    };
    struct Best {
        int number = 0;
        float distance = 0, cost = 0;
        float norm = 0;  ///< root of the distance, and the penalty: where there are penalties
        float slack = 0; ///< largest rounding error of the distance of two descriptors
        float limit = 0; ///< squared distance of descriptors up to which patches may cost less

        void setCost(float least) {
            const float root = std::sqrt(least) + slack;
            cost = least;
            limit = root * root;
        }
    };
    void consider(const Entry& entry, const PatchBasis::Descriptor& wanted, const float* pixels,
                  std::ptrdiff_t stride, Best& best) const;
    void considerPenalised(const Entry& entry, const PatchBasis::Descriptor& wanted, const float* pixels,
                           std::ptrdiff_t stride, Best& best) const;
    float distance(const float* pixels, std::ptrdiff_t stride, const Source& source, float limit) const;

    std::vector<const Interleaved*> m_images;
    const PatchBasis& m_basis;
    std::vector<Entry> m_entries; ///< by increasing first coordinate
    std::vector<Source> m_sources;
    std::vector<float> m_penalties;
};

} // namespace texloom
