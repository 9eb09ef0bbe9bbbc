#include "core/methods/patch_assignment/cost_table.h"

#include <algorithm>

namespace texloom::patch_assignment {

namespace {

/// Patches of the output that one thread takes at a time, and of the exemplar, which are then at hand for all
/// of them.
constexpr int kPersons = 8, kObjects = 64;

std::size_t product(int a, int b) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

} // namespace

void CostTable::update(int persons, const ExemplarPatches& patches, const Wanted& wanted, float slack,
                       JobContext& context) {
    m_known = m_known && m_costs.persons == persons;
    m_costs.persons = persons;
    m_costs.objects = m_costs.perRow = patches.count();
    m_costs.costs.resize(product(persons, m_costs.perRow));
    m_wanted.resize(product(persons, patches.patchFloats()));
    compute(moved(patches, wanted, slack, context), patches, context);
    m_known = true;
}

/// @return whose rows must be computed; their patches are now those of m_wanted.
std::vector<int> CostTable::moved(const ExemplarPatches& patches, const Wanted& wanted, float slack,
                                  JobContext& context) {
    const int floats = patches.patchFloats();
    std::vector<std::uint8_t> changed(static_cast<std::size_t>(m_costs.persons), 1);
    context.parallel(0, (m_costs.persons + kObjects - 1) / kObjects, [&](int chunk) {
        std::vector<float> now(static_cast<std::size_t>(floats));
        for (int n = chunk * kObjects; n < std::min(m_costs.persons, (chunk + 1) * kObjects); ++n) {
            float* before = m_wanted.data() + product(n, floats);
            wanted(n, now.data());
            if (m_known && patches.distance(now.data(), before) <= slack)
                changed[static_cast<std::size_t>(n)] = 0;
            else
                std::copy(now.begin(), now.end(), before);
        }
    });
    std::vector<int> persons;
    for (int n = 0; n < m_costs.persons; ++n)
        if (changed[static_cast<std::size_t>(n)] != 0)
            persons.push_back(n);
    return persons;
}

void CostTable::compute(const std::vector<int>& persons, const ExemplarPatches& patches,
                        JobContext& context) {
    const int count = static_cast<int>(persons.size());
    context.parallel(0, (count + kPersons - 1) / kPersons, [&](int chunk) {
        for (int first = 0; first < m_costs.objects; first += kObjects) {
            if (first % 4096 == 0)
                context.check();
            const int last = std::min(m_costs.objects, first + kObjects);
            for (int i = chunk * kPersons; i < std::min(count, (chunk + 1) * kPersons); ++i) {
                const int person = persons[static_cast<std::size_t>(i)];
                patches.costs(m_wanted.data() + product(person, patches.patchFloats()), first, last,
                              m_costs.costs.data() + product(person, m_costs.perRow) + first);
            }
        }
    });
}

} // namespace texloom::patch_assignment
