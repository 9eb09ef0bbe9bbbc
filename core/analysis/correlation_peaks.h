#pragma once

#include "core/analysis/correlation.h"
#include "core/analysis/lattice_candidate.h"

#include <functional>
#include <vector>

namespace texloom {

/// An autocorrelation γ, smoothed against noise between neighbours, and its local maxima.
class CorrelationPeaks {
public:
    /// @param check called every few milliseconds, also by everything that uses the peaks; may throw; must
    /// outlive them. @param criteria by which lattices are rated with these peaks.
    CorrelationPeaks(const Correlation& gamma, const std::function<void()>& check,
                     const LatticeCriteria& criteria);

    struct Peak {
        int x = 0, y = 0;
        float height = 0;
    };

    void check() const { m_check(); }
    const LatticeCriteria& criteria() const { return m_criteria; }
    /// Size of the exemplar.
    Size size() const { return m_smooth.size(); }
    const Correlation& smooth() const { return m_smooth; }
    bool inside(Vec2 p, int margin) const {
        return std::abs(p.x) + margin < size().width - 1 && std::abs(p.y) + margin < size().height - 1;
    }
    /// Largest smoothed γ within `reach` pixels of a point, and where.
    Peak summit(Vec2 near, int reach) const;
    /// Largest smoothed γ at a point or next to it, for lattices whose points lie between pixels.
    double height(Vec2 at) const { return static_cast<double>(summit(at, 1).height); }
    /// The maxima worth pairing, short enough for a vector: the highest, the shortest, and those far from any
    /// higher one (Lin, Wang & Yang 1997, as cited in the source's chapter 6).
    std::vector<Peak> dominant() const;

private:
    std::vector<Peak> all() const;

    const std::function<void()>& m_check;
    LatticeCriteria m_criteria;
    Correlation m_smooth;
};

} // namespace texloom
