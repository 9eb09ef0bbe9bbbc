#include "ui/window/result_export.h"

#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/export/export_dialog.h"
#include "ui/runs/run_desk.h"

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QUrl>

namespace texloom::ui {

namespace {

const QString kExportFolder = QStringLiteral("folders/export");

} // namespace

ResultExport::ResultExport(const RunDesk* desk, MessageBar* messages, QWidget* window)
    : QObject(window), m_desk(desk), m_messages(messages), m_window(window) {}

QString ResultExport::folder() const {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QString known = QFileInfo(pictures).isDir() ? pictures : QDir::homePath();
    return QSettings().value(kExportFolder, known).toString();
}

bool ResultExport::knowsHow() {
    return ExportDialog::remembers();
}

void ResultExport::exportAgain() {
    auto* dialog = new ExportDialog(m_desk->result(), folder(), m_window);
    dialog->takeLast();
    if (!dialog->refusal().isEmpty())
        return open(dialog);
    write(*dialog);
    delete dialog;
}

void ResultExport::openDialog() {
    open(new ExportDialog(m_desk->result(), folder(), m_window));
}

void ResultExport::open(ExportDialog* dialog) {
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { write(*dialog); });
    dialog->open();
}

void ResultExport::write(const ExportDialog& dialog) {
    const QString folder = dialog.folder();
    QSettings().setValue(kExportFolder, folder);
    dialog.remember();
    m_messages->say(MessageBar::Kind::Information, tr("Writing to %1…").arg(folder));
    inBackground(
        this,
        [result = dialog.result(), options = dialog.options()] { return exportResult(*result, options); },
        [this, folder](const std::vector<ExportEntry>& written) {
            const QString text = written.size() == 1
                                     ? tr("Wrote 1 file to %1.").arg(folder)
                                     : tr("Wrote %1 files to %2.").arg(written.size()).arg(folder);
            m_messages->say(MessageBar::Kind::Information, text, tr("Open folder"),
                            [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void ResultExport::copy() {
    QApplication::clipboard()->setImage(m_desk->last().pictures.result->image());
    m_messages->sayBriefly(tr("The result is on the clipboard."));
}

} // namespace texloom::ui
