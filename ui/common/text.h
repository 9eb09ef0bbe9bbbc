#pragma once

#include "core/base/message.h"
#include "core/session/run/run.h"

#include <QString>

#include <filesystem>
#include <string>

namespace texloom::ui {

/// A text that core marked with TR(), in the user's language.
QString translated(const std::string& text);
/// A message of core in the user's language, with its values.
QString translated(const Message& message);

/// A path as Qt writes it, and back.
QString toQString(const std::filesystem::path& path);
std::filesystem::path toPath(const QString& path);

/// "Image quilting", or "Locally Gaussian + Image quilting" where one method follows another.
QString titleOf(const RunPlan& plan);

/// "512 × 512".
QString sizeText(Size size);

/// "43 %" from 0.43.
QString percentText(double fraction);
/// "stopped at 43 %" from 0.43: what marks the result of a run that did not come to its end.
QString stoppedText(double fraction);

} // namespace texloom::ui
