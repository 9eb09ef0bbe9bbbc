#include "ui/session/run_recovery.h"

#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/runs/run_desk.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>

namespace texloom::ui {

RunRecovery::RunRecovery(RunDesk* desk, QWidget* window) : QObject(window), m_desk(desk), m_window(window) {}

void RunRecovery::offer(const QString& folder) {
    m_folder = folder;
    inBackground(
        this, [folder] { return newestBrokenRun(folder); },
        [this](const std::optional<BrokenRun>& run) {
            if (run)
                askWhenQuiet(*run);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void RunRecovery::askWhenQuiet(const BrokenRun& run) {
    if (const QWidget* other = QApplication::activeModalWidget())
        connect(
            other, &QObject::destroyed, this, [this, run] { askWhenQuiet(run); }, Qt::QueuedConnection);
    else
        ask(run);
}

QMessageBox* RunRecovery::makeBox(const BrokenRun& run) {
    const QString broken = tr("A run was broken off at %1: %2.").arg(percentText(run.fraction), run.label);
    const QString text = run.label.isEmpty()     ? run.refusal
                         : run.refusal.isEmpty() ? broken
                                                 : QStringLiteral("%1 %2").arg(broken, run.refusal);
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Go on with a run"), text, QMessageBox::NoButton, m_window);
    box->setObjectName(QStringLiteral("brokenRunDialog"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    return box;
}

void RunRecovery::ask(const BrokenRun& run) {
    QMessageBox* const box = makeBox(run);
    if (run.plan) {
        QPushButton* const on =
            box->addButton(tr("&Go on from %1").arg(percentText(run.fraction)), QMessageBox::AcceptRole);
        on->setObjectName(QStringLiteral("goOn"));
        box->setDefaultButton(on);
        connect(on, &QPushButton::clicked, this, [this, run] { goOn(run); });
    } else if (run.recipe) {
        QPushButton* const restore = box->addButton(tr("&Restore settings"), QMessageBox::AcceptRole);
        restore->setObjectName(QStringLiteral("restoreBroken"));
        box->setDefaultButton(restore);
        connect(restore, &QPushButton::clicked, this, [this, run] {
            discardBrokenRun(run.file);
            Q_EMIT restoreWanted(*run.recipe);
        });
    }
    QPushButton* const discard = box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    discard->setObjectName(QStringLiteral("discardBroken"));
    connect(discard, &QPushButton::clicked, this, [this, run] {
        discardBrokenRun(run.file);
        offer(m_folder);
    });
    box->setEscapeButton(box->addButton(tr("&Later"), QMessageBox::RejectRole));
    box->open();
}

void RunRecovery::goOn(const BrokenRun& run) {
    m_desk->resume(run);
    Q_EMIT resumed(*run.recipe);
}

} // namespace texloom::ui
