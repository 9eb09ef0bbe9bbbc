#pragma once

#include "core/session/run/exemplar_file.h"

#include <QString>

#include <functional>

namespace texloom::ui {

/// A picture that a workspace can be given: an exemplar that is open, or a result.
struct NamedImage {
    using Fetched = std::function<void(const ExemplarFile&)>;
    using Failed = std::function<void(const QString&)>;

    QString title;
    ExemplarFile file; ///< without an image as long as it has to be fetched
    /// Brings the image where it is not at hand, such as an earlier result's, and calls one of the two.
    std::function<void(const Fetched&, const Failed&)> fetch = {};
};

} // namespace texloom::ui
