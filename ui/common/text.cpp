#include "ui/common/text.h"

#include <QCoreApplication>
#include <QFile>

#include <cmath>

namespace texloom::ui {

QString translated(const std::string& text) {
    // An empty text would be translated to what the file says of itself.
    return text.empty() ? QString() : QCoreApplication::translate("core", text.c_str());
}

QString translated(const Message& message) {
    return QString::fromStdString(
        message.text([](const std::string& pattern) { return translated(pattern).toStdString(); }));
}

QString toQString(const std::filesystem::path& path) {
    return QFile::decodeName(path.c_str());
}

std::filesystem::path toPath(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

QString titleOf(const RunPlan& plan) {
    QStringList titles;
    for (const RunStep& step : plan.steps)
        titles += translated(step.method->info().title);
    return titles.join(QStringLiteral(" + "));
}

QString sizeText(Size size) {
    return QCoreApplication::translate("text", "%1 × %2").arg(size.width).arg(size.height);
}

QString percentText(double fraction) {
    return QCoreApplication::translate("text", "%1 %").arg(static_cast<int>(std::floor(fraction * 100)));
}

QString stoppedText(double fraction) {
    return QCoreApplication::translate("text", "stopped at %1").arg(percentText(fraction));
}

} // namespace texloom::ui
