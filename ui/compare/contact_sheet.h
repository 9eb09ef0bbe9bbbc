#pragma once

#include "ui/compare/compare_item.h"

#include <QFont>
#include <QImage>
#include <QString>

#include <vector>

namespace texloom::ui {

/// All pictures in a grid on white, each with its label below it; messages where there is no picture. Called
/// on a worker. @param heading what they have in common, over all of them; none if empty.
/// @param side longest side of a picture on the sheet, in pixels.
QImage contactSheet(const std::vector<CompareItem>& items, const QString& heading, int columns, int side,
                    const QFont& font);

/// Writes it as a PNG, whole or not at all. Called on a worker. @throws Error
void writeSheet(const QImage& sheet, const QString& path);

} // namespace texloom::ui
