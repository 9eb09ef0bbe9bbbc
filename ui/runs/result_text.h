#pragma once

#include "core/session/results/result_files.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace texloom::ui {

/// "Image quilting", or "Locally Gaussian + Image quilting".
QString methodsText(const ResultEntry& entry);

/// The user's name for a result, or its methods.
QString titleText(const ResultEntry& entry);

/// "Image quilting · seed 1 · 512 × 512": what tells one result from others.
QString labelText(const ResultEntry& entry);

/// What a card says below its title: seed, size, time taken, and whether it is a preview.
QStringList chipsOf(const ResultEntry& entry);

/// All there is to know of a result, as rich text: exemplars, settings, time, figures, notes.
QString detailsText(const ResultEntry& entry);

/// Figures in rich text, a row each; empty for none.
QString figuresText(const std::vector<Figure>& figures);

/// What a search looks in.
QString searchText(const ResultEntry& entry);

} // namespace texloom::ui
