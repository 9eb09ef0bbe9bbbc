#include "ui/lattice/given_lattices.h"

#include "core/analysis/lattice_values.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/inspector/inspector.h"

#include <vector>

namespace texloom::ui {

void GivenLattices::follow(const ExemplarEntry* current, Inspector& inspector) {
    if (current == nullptr || inspector.method() == nullptr)
        return;
    const int before = m_id;
    const Size size = current->file().image->size(), sizeBefore = m_size;
    if (current->id == before && size == sizeBefore)
        return;
    m_id = current->id;
    m_size = size;
    const Method& method = *inspector.method();
    const std::vector<Param>& params = method.params();
    if (before == 0 || !followsLattice(params))
        return;
    const Values values = inspector.values();
    const bool given = givenLattice(params, values).has_value();
    if (given)
        m_given[before] = {sizeBefore, latticeValues(params, values)};
    else
        m_given.erase(before);
    const auto own = m_given.find(current->id);
    if (own != m_given.end() && own->second.size == size)
        inspector.changeValues(own->second.values);
    else if (given)
        inspector.changeValues(latticeValues(params, method.defaults({})));
}

} // namespace texloom::ui
