#include "ui/jobs/job_panel.h"

#include "core/base/text.h"
#include "ui/common/flow_layout.h"
#include "ui/common/icons.h"
#include "ui/common/text.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cmath>
#include <thread>

namespace texloom::ui {

namespace {

constexpr int kBarSteps = 1000;
constexpr int kNameWidths = 60;
constexpr int kStateWidths = 44;
const QString kThreads = QStringLiteral("jobs/threads");

enum Column { NameColumn, StateColumn, TimeColumn };
enum Role { IdRole = Qt::UserRole, FractionRole };

/// Paints a bar where a run is under way, and text elsewhere.
class StateDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QVariant fraction = index.data(FractionRole);
        if (!fraction.isValid())
            return QStyledItemDelegate::paint(painter, option, index);
        QStyleOptionProgressBar bar;
        bar.QStyleOption::operator=(option);
        bar.rect = option.rect.adjusted(1, 1, -1, -1);
        bar.state = option.state | QStyle::State_Horizontal;
        bar.maximum = kBarSteps;
        bar.progress = static_cast<int>(fraction.toDouble() * kBarSteps);
        bar.text = index.data(Qt::DisplayRole).toString();
        bar.textVisible = true;
        bar.textAlignment = Qt::AlignCenter;
        QApplication::style()->drawControl(QStyle::CE_ProgressBar, &bar, painter, option.widget);
    }
};

QString seconds(double value) {
    return QString::fromStdString(durationText(value < 10 ? value : std::round(value)));
}

QString timeText(const QueuedJob& job) {
    if (job.state == QueuedJob::State::Running)
        return job.progress.left ? JobPanel::tr("%1, %2 left")
                                       .arg(seconds(job.progress.seconds), seconds(*job.progress.left))
                                 : seconds(job.progress.seconds);
    if (job.state == QueuedJob::State::Waiting && job.expected)
        return JobPanel::tr("about %1").arg(seconds(*job.expected));
    return {};
}

QString stateText(const QueuedJob& job) {
    switch (job.state) {
    case QueuedJob::State::Running:
        return job.progress.stage.isEmpty()
                   ? percentText(job.progress.fraction)
                   : JobPanel::tr("%1 · %2").arg(percentText(job.progress.fraction), job.progress.stage);
    case QueuedJob::State::Failed:
        return JobPanel::tr("Failed: %1").arg(job.problem);
    case QueuedJob::State::Waiting:
        break;
    }
    return JobPanel::tr("waiting");
}

void showJob(QTreeWidgetItem& item, const QueuedJob& job) {
    item.setData(NameColumn, IdRole, job.id);
    item.setText(NameColumn, job.quick ? JobPanel::tr("%1 (preview)").arg(job.label) : job.label);
    item.setText(StateColumn, stateText(job));
    item.setToolTip(StateColumn, job.problem);
    item.setData(StateColumn, FractionRole,
                 job.state == QueuedJob::State::Running ? QVariant(job.progress.fraction) : QVariant());
    item.setText(TimeColumn, timeText(job));
}

} // namespace

JobPanel::JobPanel(JobQueue* queue, QWidget* parent)
    : QWidget(parent), m_queue(queue), m_list(new QTreeWidget(this)), m_empty(new QLabel(this)),
      m_threads(new QSpinBox(this)),
      m_up(makeAction("jobUp", tr("Move &up"), tr("Move the chosen run forward in the queue"), "up")),
      m_down(makeAction("jobDown", tr("Move &down"), tr("Move the chosen run back in the queue"), "down")),
      m_stop(makeAction("stopJob", tr("&Stop and keep"),
                        tr("End the run under way and keep what is there as a result"), "stop")),
      m_cancel(makeAction("cancelJob", tr("&Cancel"),
                          tr("Take the chosen run off the queue; of one under way, nothing is kept"),
                          "close")),
      m_pause(makeAction("pauseJobs", tr("&Pause"),
                         tr("Start none of the waiting runs; the one under way goes on, and Run still works"),
                         "pause")),
      m_clear(makeAction("clearJobs", tr("C&lear"), tr("Take all waiting and failed runs off the queue"),
                         nullptr)) {
    setObjectName(QStringLiteral("jobPanel"));
    m_pause->setCheckable(true);
    m_cancel->setShortcut(QKeySequence::Delete);
    m_cancel->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_list->setObjectName(QStringLiteral("jobList"));
    m_list->setAccessibleName(tr("Runs that wait or are under way"));
    m_list->setToolTip(tr("Double click or Return on the run under way shows its pictures as they are made"));
    m_list->setHeaderLabels({tr("Run"), tr("Progress"), tr("Time")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setItemDelegateForColumn(StateColumn, new StateDelegate(m_list));
    m_list->setColumnWidth(NameColumn, fontMetrics().averageCharWidth() * kNameWidths);
    m_list->setColumnWidth(StateColumn, fontMetrics().averageCharWidth() * kStateWidths);
    m_list->addActions({m_up, m_down, m_stop, m_cancel});
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_empty->setText(
        tr("No run is waiting. “Add to queue” puts one here, to be made after those before it."));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);

    auto* column = new QVBoxLayout(this);
    column->addWidget(makeBar());
    column->addWidget(m_empty, 1);
    column->addWidget(m_list, 1);
    connect(m_queue, &JobQueue::changed, this, &JobPanel::fill);
    connect(m_queue, &JobQueue::progressed, this, &JobPanel::showProgress);
    connect(m_queue, &JobQueue::pausedChanged, m_pause, &QAction::setChecked);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &JobPanel::updateActions);
    connect(m_list, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
        const int id = item->data(NameColumn, IdRole).toInt();
        if (const QueuedJob* current = m_queue->current(); current != nullptr && current->id == id)
            Q_EMIT watchWanted(id);
    });
    connect(m_up, &QAction::triggered, this, [this] { m_queue->move(selected(), -1); });
    connect(m_down, &QAction::triggered, this, [this] { m_queue->move(selected(), 1); });
    connect(m_stop, &QAction::triggered, this, [this] {
        if (const QueuedJob* under = m_queue->current())
            m_queue->stopAndKeep(under->id);
    });
    connect(m_cancel, &QAction::triggered, this, [this] { m_queue->cancel(selected()); });
    connect(m_pause, &QAction::toggled, m_queue, &JobQueue::setPaused);
    connect(m_clear, &QAction::triggered, m_queue, &JobQueue::clear);
    fill();
}

QAction* JobPanel::makeAction(const char* name, const QString& text, const QString& help,
                              const char* iconName) {
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(help);
    if (iconName != nullptr)
        action->setIcon(icon(QLatin1String(iconName)));
    return action;
}

QWidget* JobPanel::makeBar() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar);
    for (QAction* action : {m_pause, m_up, m_down, m_stop, m_cancel, m_clear}) {
        auto* button = new QToolButton(bar);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(button);
    }
    row->addWidget(makeThreads());
    return bar;
}

QWidget* JobPanel::makeThreads() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("At &most"), box);
    label->setBuddy(m_threads);
    m_threads->setObjectName(QStringLiteral("jobThreads"));
    m_threads->setAccessibleName(tr("Most threads that runs may use"));
    m_threads->setRange(0, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    m_threads->setSpecialValueText(tr("all threads"));
    m_threads->setSuffix(tr(" threads"));
    m_threads->setToolTip(tr("How many of the processor's threads runs may use from now on. Fewer leave the "
                             "computer free for other work; the results are the same."));
    connect(m_threads, &QSpinBox::valueChanged, this, [this](int threads) {
        m_queue->setThreads(threads);
        QSettings().setValue(kThreads, threads);
    });
    m_threads->setValue(QSettings().value(kThreads, 0).toInt());
    row->addWidget(label);
    row->addWidget(m_threads);
    return box;
}

int JobPanel::selected() const {
    const QList<QTreeWidgetItem*> chosen = m_list->selectedItems();
    return chosen.isEmpty() ? 0 : chosen.front()->data(NameColumn, IdRole).toInt();
}

void JobPanel::fill() {
    const int chosen = selected();
    const auto& jobs = m_queue->jobs();
    while (m_list->topLevelItemCount() > static_cast<int>(jobs.size()))
        delete m_list->takeTopLevelItem(m_list->topLevelItemCount() - 1);
    while (m_list->topLevelItemCount() < static_cast<int>(jobs.size()))
        m_list->addTopLevelItem(new QTreeWidgetItem);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        QTreeWidgetItem* const item = m_list->topLevelItem(static_cast<int>(i));
        showJob(*item, jobs[i]);
        if (jobs[i].id == chosen)
            m_list->setCurrentItem(item);
    }
    m_empty->setVisible(jobs.empty());
    m_list->setVisible(!jobs.empty());
    updateActions();
}

void JobPanel::showProgress(int id) {
    const QueuedJob* const job = m_queue->find(id);
    if (job != nullptr && m_list->topLevelItemCount() > 0 && isVisible())
        showJob(*m_list->topLevelItem(0), *job);
}

void JobPanel::updateActions() {
    const QueuedJob* const job = m_queue->find(selected());
    const bool waits = job != nullptr && job->state == QueuedJob::State::Waiting;
    for (QAction* action : {m_up, m_down})
        action->setEnabled(waits);
    m_cancel->setEnabled(job != nullptr);
    m_stop->setEnabled(m_queue->current() != nullptr);
    const auto under = m_queue->current() != nullptr ? 1U : 0U;
    m_clear->setEnabled(m_queue->jobs().size() > under);
}

} // namespace texloom::ui
