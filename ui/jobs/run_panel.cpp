#include "ui/jobs/run_panel.h"

#include "core/base/text.h"
#include "ui/common/action_button.h"
#include "ui/common/appearance.h"
#include "ui/common/text.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

constexpr int kRunBarSteps = 1000;

} // namespace

RunPanel::RunPanel(const Buttons& actions, QWidget* parent)
    : QWidget(parent), m_note(new QLabel(this)), m_stage(new QLabel(this)), m_time(new QLabel(this)),
      m_bar(new QProgressBar(this)) {
    setObjectName(QStringLiteral("runPanel"));
    m_note->setObjectName(QStringLiteral("runNote"));
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    m_bar->setObjectName(QStringLiteral("runProgress"));
    m_bar->setRange(0, kRunBarSteps);
    m_bar->setAccessibleName(tr("Progress of the run"));
    m_stage->setTextFormat(Qt::PlainText);

    auto* buttons = new QHBoxLayout;
    auto* primary = new ActionButton(actions.run, this);
    primary->setDefault(true);
    buttons->addWidget(primary, 2);
    buttons->addWidget(makeIconButton(actions.queue, QStringLiteral("queueButton")));
    buttons->addWidget(new ActionButton(actions.quick, this), 1);
    buttons->addWidget(new ActionButton(actions.stop, this), 1);
    buttons->addWidget(makeIconButton(actions.cancel, QStringLiteral("cancelRunButton")));
    auto* texts = new QHBoxLayout;
    texts->addWidget(m_stage, 1);
    texts->addWidget(m_time);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(buttons);
    column->addWidget(m_note);
    column->addWidget(m_bar);
    column->addLayout(texts);
    setRunning(false);
}

QToolButton* RunPanel::makeIconButton(QAction* action, const QString& name) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAccessibleName(action->text().remove(QLatin1Char('&')));
    return button;
}

void RunPanel::setEstimate(const Estimate& estimate, std::optional<double> seconds) {
    const QString memory = QString::fromStdString(byteText(estimate.bytes));
    if (!seconds)
        return say(tr("Needs %1 of memory").arg(memory), {});
    const QString time =
        *seconds < 1
            ? tr("under 1 s")
            : tr("about %1")
                  .arg(QString::fromStdString(durationText(*seconds < 10 ? *seconds : std::round(*seconds))));
    say(tr("Takes %1 · %2 of memory").arg(time, memory), {});
}

void RunPanel::setRefusal(const QString& sentence) {
    say(tr("Cannot run: %1").arg(sentence), sentence);
}

void RunPanel::setHint(const QString& text) {
    say(text, {});
}

void RunPanel::say(const QString& text, const QString& refusal) {
    m_refusal = refusal;
    m_note->setText(text);
    colorNote();
}

void RunPanel::colorNote() {
    QPalette colors = palette();
    if (!m_refusal.isEmpty())
        colors.setColor(QPalette::WindowText, errorColor(colors));
    m_note->setPalette(colors);
}

void RunPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        colorNote();
}

void RunPanel::setRunning(bool running, int waiting) {
    m_waiting = waiting;
    m_note->setVisible(!running || !m_refusal.isEmpty());
    for (QWidget* shown :
         {static_cast<QWidget*>(m_bar), static_cast<QWidget*>(m_stage), static_cast<QWidget*>(m_time)})
        shown->setVisible(running);
}

void RunPanel::showProgress(const RunProgress& progress) {
    m_bar->setValue(static_cast<int>(progress.fraction * kRunBarSteps));
    m_bar->setFormat(percentText(progress.fraction));
    const QString waiting = m_waiting > 0 ? tr("%1 waiting").arg(m_waiting) : QString();
    const bool both = m_waiting > 0 && !progress.stage.isEmpty();
    m_stage->setText(both ? tr("%1 · %2").arg(progress.stage, waiting) : progress.stage + waiting);
    const QString passed = QString::fromStdString(durationText(progress.seconds));
    m_time->setText(progress.left
                        ? tr("%1, %2 left").arg(passed, QString::fromStdString(durationText(*progress.left)))
                        : passed);
}

} // namespace texloom::ui
