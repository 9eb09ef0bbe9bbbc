#include "core/methods/patch_assignment/cost_table.h"

#include <algorithm>
#include <cmath>

namespace texloom::patch_assignment {

namespace {

/// Patches of the output that one thread takes at a time, and of the exemplar, which then stay cached for all
/// of them.
constexpr int kRows = 8, kColumns = 64;
/// Patches of the output, and of the exemplar, whose bounds are compared with the costs, and the ratio of
/// bounds to costs below which so many costs would be requested one by one that it is faster to compute all.
constexpr int kSampledRows = 32, kSampledColumns = 256;
constexpr double kNear = 0.9;

std::size_t product(int a, int b) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

} // namespace

void CostTable::update(int rows, const ExemplarPatches& patches, const Wanted& wanted,
                       const Tolerance& tolerance, JobContext& context) {
    m_known = m_known && m_costs.rows == rows;
    m_costs.rows = rows;
    m_costs.columns = m_costs.perRow = patches.kinds();
    m_costs.costs.resize(product(rows, m_costs.perRow));
    m_wanted.resize(product(rows, patches.patchFloats()));
    m_fallen.resize(product(rows, 1));
    m_costs.cost = nullptr;
    if (tolerance.bounds)
        m_costs.cost = [this, &patches](int row, std::span<const int> columns, float* to) {
            patches.costs(patchOf(row, patches), columns, to);
        };
    compute(moved(patches, wanted, tolerance, context), patches, context);
    m_known = true;
}

/// @return the rows that must be computed; their patches are now those of m_wanted.
std::vector<int> CostTable::moved(const ExemplarPatches& patches, const Wanted& wanted,
                                  const Tolerance& tolerance, JobContext& context) {
    const int floats = patches.patchFloats();
    std::vector<std::uint8_t> changed(product(m_costs.rows, 1), 0);
    context.parallel(0, (m_costs.rows + kColumns - 1) / kColumns, [&](int chunk) {
        std::vector<float> now(static_cast<std::size_t>(floats));
        for (int n = chunk * kColumns; n < std::min(m_costs.rows, (chunk + 1) * kColumns); ++n) {
            float* before = m_wanted.data() + product(n, floats);
            wanted(n, now.data());
            const float moved = m_known ? patches.distance(now.data(), before) : HUGE_VALF;
            if (moved <= tolerance.keep)
                continue;
            std::copy(now.begin(), now.end(), before);
            changed[static_cast<std::size_t>(n)] = outlives(n, moved, tolerance) ? 0 : 1;
        }
    });
    std::vector<int> rows;
    for (int n = 0; n < m_costs.rows; ++n)
        if (changed[static_cast<std::size_t>(n)] != 0)
            rows.push_back(n);
    return rows;
}

/// Lowers a row of bounds by the distance its patch has moved. @return whether it is still of use.
bool CostTable::outlives(int row, float moved, const Tolerance& tolerance) {
    float& fallen = m_fallen[static_cast<std::size_t>(row)];
    fallen += moved;
    if (!tolerance.bounds || !(fallen <= tolerance.fall)) {
        fallen = 0;
        return false;
    }
    float* values = m_costs.valuesOf(row);
    const float most = (1 + ExemplarPatches::kRounding) * moved;
    for (int i = 0; i < m_costs.perRow; ++i)
        values[i] = -std::max(0.0F, (1 - ExemplarPatches::kRounding) * std::abs(values[i]) - most);
    return true;
}

/// Whether the bounds of some patches are close to the costs.
bool CostTable::near(const std::vector<int>& rows, const ExemplarPatches& patches) const {
    std::vector<float> sums(product(1, patches.sumFloats()));
    double bounds = 0, costs = 0;
    for (std::size_t i = 0; i < rows.size(); i += 1 + rows.size() / kSampledRows) {
        const float* patch = patchOf(rows[i], patches);
        patches.sums(patch, sums.data());
        for (int column = 0; column < m_costs.columns; column += 1 + m_costs.columns / kSampledColumns) {
            float bound = 0;
            patches.bounds(sums.data(), column, column + 1, &bound);
            bounds += static_cast<double>(std::abs(bound));
            costs += static_cast<double>(patches.cost(patch, column));
        }
    }
    return bounds >= kNear * costs;
}

void CostTable::compute(const std::vector<int>& rows, const ExemplarPatches& patches, JobContext& context) {
    const int count = static_cast<int>(rows.size());
    const bool bounds = m_costs.bounded() && near(rows, patches);
    context.parallel(0, (count + kRows - 1) / kRows, [&](int chunk) {
        const int begin = chunk * kRows, end = std::min(count, begin + kRows);
        std::vector<float> sums(product(kRows, patches.sumFloats()));
        if (bounds)
            for (int i = begin; i < end; ++i)
                patches.sums(patchOf(rows[static_cast<std::size_t>(i)], patches),
                             sums.data() + product(i - begin, patches.sumFloats()));
        for (int first = 0; first < m_costs.columns; first += kColumns) {
            if (first % 4096 == 0)
                context.check();
            const int last = std::min(m_costs.columns, first + kColumns);
            for (int i = begin; i < end; ++i) {
                const int row = rows[static_cast<std::size_t>(i)];
                float* to = m_costs.valuesOf(row) + first;
                if (bounds)
                    patches.bounds(sums.data() + product(i - begin, patches.sumFloats()), first, last, to);
                else
                    patches.costs(patchOf(row, patches), first, last, to);
            }
        }
    });
}

} // namespace texloom::patch_assignment
