#pragma once

#include "core/job/job_context.h"
#include "core/math/assignment.h"
#include "core/methods/patch_assignment/patches.h"

#include <functional>
#include <vector>

namespace texloom::patch_assignment {

/// What it costs to give patches of the output each of the exemplar's, kept from one iteration to the next: a
/// row is computed again only when its patch has changed.
class CostTable {
public:
    /// Writes patch `person` of the output in the form of ExemplarPatches::planar().
    using Wanted = std::function<void(int person, float* to)>;

    /// Brings the rows of `persons` patches up to date. Costs are norms of differences: where a patch has
    /// moved by no more than `slack` since its row was computed, so have all costs of the row, which is kept.
    void update(int persons, const ExemplarPatches& patches, const Wanted& wanted, float slack,
                JobContext& context);
    /// Makes the next update compute everything.
    void forget() { m_known = false; }
    const AssignmentCosts& costs() const { return m_costs; }

private:
    std::vector<int> moved(const ExemplarPatches& patches, const Wanted& wanted, float slack,
                           JobContext& context);
    void compute(const std::vector<int>& persons, const ExemplarPatches& patches, JobContext& context);

    AssignmentCosts m_costs;
    std::vector<float> m_wanted; ///< the patches that the rows were computed for
    bool m_known = false;
};

} // namespace texloom::patch_assignment
