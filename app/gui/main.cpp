#include "core/base/version.h"
#include "ui/window/appearance.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Texloom"));
    QApplication::setApplicationName(QStringLiteral("texloom"));
    QApplication::setApplicationDisplayName(QStringLiteral("Texloom"));
    QApplication::setApplicationVersion(QLatin1String(texloom::kVersion));
    QApplication::setDesktopFileName(QStringLiteral("texloom"));

    QCommandLineParser arguments;
    arguments.setApplicationDescription(
        QCoreApplication::translate("main", "A workbench for exemplar-based texture synthesis."));
    arguments.addHelpOption();
    arguments.addVersionOption();
    arguments.addPositionalArgument(QStringLiteral("files"),
                                    QCoreApplication::translate("main", "Exemplars or a recipe to open."),
                                    QStringLiteral("[files…]"));
    arguments.process(application);

    texloom::ui::applyAppearance(texloom::ui::savedAppearance());
    texloom::ui::MainWindow window;
    window.show();
    window.openFiles(arguments.positionalArguments());
    return QApplication::exec();
}
