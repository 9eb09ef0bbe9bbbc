#pragma once

#include "core/base/value.h"
#include "core/image/size.h"

#include <map>

namespace texloom::ui {

struct ExemplarEntry;
class Inspector;

/// A lattice that is given to a method belongs to the exemplar that it was given for: with another exemplar
/// the method looks for a lattice by itself, and finds the given one again when the first comes back.
class GivenLattices {
public:
    /// To be called when another exemplar may be looked at. @param current null if there is none.
    void follow(const ExemplarEntry* current, Inspector& inspector);

private:
    struct Given {
        Size size; ///< of the exemplar: another one after it was cropped or rectified
        Values values;
    };

    int m_id = 0; ///< the exemplar that the settings are for; 0 before the first
    Size m_size;
    std::map<int, Given> m_given;
};

} // namespace texloom::ui
