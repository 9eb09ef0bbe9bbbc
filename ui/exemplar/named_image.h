#pragma once

#include "core/session/exemplar_file.h"

#include <QString>

namespace texloom::ui {

/// A picture that a workspace can be given: an exemplar that is open, or a result.
struct NamedImage {
    QString title;
    ExemplarFile file;
};

} // namespace texloom::ui
