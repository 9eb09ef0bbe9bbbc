#include "core/base/version.h"
#include "core/io/decoder_process.h"
#include "core/job/address_space.h"
#include "core/job/leave_program.h"
#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/language.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>

#include <memory>

namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which are not set up then either
using Early = void(int, char**, char**);
[[gnu::section(".preinit_array"), gnu::used]] Early* const beforeLibraries = texloom::endWhereAddressesAreFew;
#endif

int run(int argc, char** argv) {
    const QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Texloom"));
    QApplication::setApplicationName(QStringLiteral("texloom"));
    QApplication::setApplicationDisplayName(QStringLiteral("Texloom"));
    QApplication::setApplicationVersion(QLatin1String(texloom::kVersion));
    QApplication::setDesktopFileName(QStringLiteral("texloom"));

    texloom::ui::useLanguage(QLocale());

    QCommandLineParser arguments;
    arguments.setApplicationDescription(
        QCoreApplication::translate("main", "A workbench for exemplar-based texture synthesis."));
    arguments.addHelpOption();
    arguments.addVersionOption();
    arguments.addPositionalArgument(
        QStringLiteral("files"),
        QCoreApplication::translate("main", "Exemplars, a recipe or a session to open."),
        QStringLiteral("[files…]"));
    arguments.process(application);

    texloom::ui::applyAppearance(texloom::ui::savedAppearance());
    auto window = std::make_unique<texloom::ui::MainWindow>();
    window->show();
    window->openFiles(arguments.positionalArguments());
    window->offerRecovery();
    const int status = QApplication::exec();
    window.reset();
    texloom::ui::workers().waitForDone();
    return status;
}

} // namespace

int main(int argc, char** argv) {
    texloom::DecoderProcess::start(); // before anything has threads
    texloom::leaveProgram(run(argc, argv));
}
