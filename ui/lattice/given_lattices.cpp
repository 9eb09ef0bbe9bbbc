#include "ui/lattice/given_lattices.h"

#include "ui/exemplar/exemplar_store.h"
#include "ui/inspector/inspector.h"
#include "ui/lattice/lattice_values.h"

#include <string>

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
    if (before == 0 || !followsLattice(method))
        return;
    const Values values = inspector.values();
    const bool given = givenLattice(method, values).has_value();
    if (given)
        m_given[before] = {sizeBefore, latticeValues(values)};
    else
        m_given.erase(before);
    const auto own = m_given.find(current->id);
    if (own != m_given.end() && own->second.size == size)
        inspector.changeValues(own->second.values);
    else if (given)
        inspector.changeValues(latticeValues(method.defaults({})));
}

} // namespace texloom::ui
