#include "core/methods/patch_assignment/cost_table.h"

#include <algorithm>
#include <cmath>

namespace texloom::patch_assignment {

namespace {

/// Patches of the output that one thread takes at a time, and of the exemplar, which are then at hand for all
/// of them.
constexpr int kPersons = 8, kObjects = 64;
/// Patches of the output, and of the exemplar, whose bounds are compared with the costs, and the share of
/// these below which so many would be asked for, one by one, that it is quicker to compute all.
constexpr int kSampledPersons = 32, kSampledObjects = 256;
constexpr double kNear = 0.9;

std::size_t product(int a, int b) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

} // namespace

void CostTable::update(int persons, const ExemplarPatches& patches, const Wanted& wanted,
                       const Tolerance& tolerance, JobContext& context) {
    m_known = m_known && m_costs.persons == persons;
    m_costs.persons = persons;
    m_costs.objects = m_costs.perRow = patches.count();
    m_costs.costs.resize(product(persons, m_costs.perRow));
    m_wanted.resize(product(persons, patches.patchFloats()));
    m_fallen.resize(product(persons, 1));
    m_costs.cost = nullptr;
    if (tolerance.bounds)
        m_costs.cost = [this, &patches](int person, std::span<const int> objects, float* to) {
            patches.costs(patchOf(person, patches), objects, to);
        };
    compute(moved(patches, wanted, tolerance, context), patches, context);
    m_known = true;
}

/// @return whose rows must be computed; their patches are now those of m_wanted.
std::vector<int> CostTable::moved(const ExemplarPatches& patches, const Wanted& wanted,
                                  const Tolerance& tolerance, JobContext& context) {
    const int floats = patches.patchFloats();
    std::vector<std::uint8_t> changed(product(m_costs.persons, 1), 0);
    context.parallel(0, (m_costs.persons + kObjects - 1) / kObjects, [&](int chunk) {
        std::vector<float> now(static_cast<std::size_t>(floats));
        for (int n = chunk * kObjects; n < std::min(m_costs.persons, (chunk + 1) * kObjects); ++n) {
            float* before = m_wanted.data() + product(n, floats);
            wanted(n, now.data());
            const float moved = m_known ? patches.distance(now.data(), before) : HUGE_VALF;
            if (moved <= tolerance.keep)
                continue;
            std::copy(now.begin(), now.end(), before);
            changed[static_cast<std::size_t>(n)] = outlives(n, moved, tolerance) ? 0 : 1;
        }
    });
    std::vector<int> persons;
    for (int n = 0; n < m_costs.persons; ++n)
        if (changed[static_cast<std::size_t>(n)] != 0)
            persons.push_back(n);
    return persons;
}

/// Lets a row of bounds fall by what its patch has moved. @return whether it still says something.
bool CostTable::outlives(int person, float moved, const Tolerance& tolerance) {
    float& fallen = m_fallen[static_cast<std::size_t>(person)];
    fallen += moved;
    if (!tolerance.bounds || !(fallen <= tolerance.fall)) {
        fallen = 0;
        return false;
    }
    float* row = m_costs.row(person);
    const float most = (1 + ExemplarPatches::kRounding) * moved;
    for (int i = 0; i < m_costs.perRow; ++i)
        row[i] = -std::max(0.0F, (1 - ExemplarPatches::kRounding) * std::abs(row[i]) - most);
    return true;
}

/// Whether the bounds of some patches come near the costs.
bool CostTable::near(const std::vector<int>& persons, const ExemplarPatches& patches) const {
    std::vector<float> sums(product(1, patches.sumFloats()));
    double bounds = 0, costs = 0;
    for (std::size_t i = 0; i < persons.size(); i += 1 + persons.size() / kSampledPersons) {
        const float* patch = patchOf(persons[i], patches);
        patches.sums(patch, sums.data());
        for (int object = 0; object < m_costs.objects; object += 1 + m_costs.objects / kSampledObjects) {
            float bound = 0;
            patches.bounds(sums.data(), object, object + 1, &bound);
            bounds += static_cast<double>(std::abs(bound));
            costs += static_cast<double>(patches.cost(patch, object));
        }
    }
    return bounds >= kNear * costs;
}

void CostTable::compute(const std::vector<int>& persons, const ExemplarPatches& patches,
                        JobContext& context) {
    const int count = static_cast<int>(persons.size());
    const bool bounds = m_costs.bounded() && near(persons, patches);
    context.parallel(0, (count + kPersons - 1) / kPersons, [&](int chunk) {
        const int begin = chunk * kPersons, end = std::min(count, begin + kPersons);
        std::vector<float> sums(product(kPersons, patches.sumFloats()));
        if (bounds)
            for (int i = begin; i < end; ++i)
                patches.sums(patchOf(persons[static_cast<std::size_t>(i)], patches),
                             sums.data() + product(i - begin, patches.sumFloats()));
        for (int first = 0; first < m_costs.objects; first += kObjects) {
            if (first % 4096 == 0)
                context.check();
            const int last = std::min(m_costs.objects, first + kObjects);
            for (int i = begin; i < end; ++i) {
                const int person = persons[static_cast<std::size_t>(i)];
                float* to = m_costs.row(person) + first;
                if (bounds)
                    patches.bounds(sums.data() + product(i - begin, patches.sumFloats()), first, last, to);
                else
                    patches.costs(patchOf(person, patches), first, last, to);
            }
        }
    });
}

} // namespace texloom::patch_assignment
