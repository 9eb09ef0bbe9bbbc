#pragma once

#include "core/job/job_context.h"
#include "core/math/assignment.h"
#include "core/methods/patch_assignment/patches.h"

#include <functional>
#include <vector>

namespace texloom::patch_assignment {

/// The costs of assigning each of the exemplar's patches to patches of the output, kept from one iteration to
/// the next: a row is computed again only when its patch has changed. Where the assignment need not be
/// optimal, rows begin as bounds, which take a quarter of the time, as long as these are close to the costs.
class CostTable {
public:
    /// Writes the patch of the output that a row is for, in the form of ExemplarPatches::planar().
    using Wanted = std::function<void(int row, float* to)>;

    /// When rows stay valid although their patches change. Costs are norms of differences: when a patch moves
    /// by d, each of its costs changes by at most d.
    struct Tolerance {
        float keep = 0; ///< a row is kept while its patch has moved by at most this since it was computed
        /// Whether rows begin as bounds, which are lowered by the distance the patch has moved, up to `fall`
        /// in total.
        bool bounds = false;
        float fall = 0;
    };

    /// Brings the rows, one for each of the output's patches, up to date. With bounds, `patches` must outlive
    /// the assignment.
    void update(int rows, const ExemplarPatches& patches, const Wanted& wanted, const Tolerance& tolerance,
                JobContext& context);
    /// Makes the next update compute everything.
    void forget() { m_known = false; }
    AssignmentCosts& costs() { return m_costs; }

private:
    std::vector<int> moved(const ExemplarPatches& patches, const Wanted& wanted, const Tolerance& tolerance,
                           JobContext& context);
    bool near(const std::vector<int>& rows, const ExemplarPatches& patches) const;
    bool outlives(int row, float moved, const Tolerance& tolerance);
    const float* patchOf(int row, const ExemplarPatches& patches) const {
        return m_wanted.data() +
               static_cast<std::size_t>(row) * static_cast<std::size_t>(patches.patchFloats());
    }
    void compute(const std::vector<int>& rows, const ExemplarPatches& patches, JobContext& context);

    AssignmentCosts m_costs;
    std::vector<float> m_wanted; ///< the patches that the rows are for
    std::vector<float> m_fallen; ///< by how much the bounds of each row have fallen
    bool m_known = false;
};

} // namespace texloom::patch_assignment
