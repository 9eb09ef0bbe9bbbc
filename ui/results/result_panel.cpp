#include "ui/results/result_panel.h"

#include "core/base/text.h"
#include "ui/common/flow_layout.h"
#include "ui/common/icons.h"
#include "ui/common/shortcuts.h"
#include "ui/results/difference_dialog.h"
#include "ui/results/limits_dialog.h"
#include "ui/results/result_delegate.h"
#include "ui/results/result_filter.h"
#include "ui/runs/result_text.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

constexpr int kSearchWidths = 24;
constexpr std::chrono::milliseconds kShowPause{80};
constexpr int kNameWidths = 32; ///< of a result in a menu
const QString kKind = QStringLiteral("results/shown");
/// A comparison shows this many at most.
constexpr std::size_t kMostCompared = 9;

QAction* make(QWidget* window, const char* name, const QString& text, const QString& help,
              const QKeySequence& key = {}, const char* iconName = nullptr) {
    auto* action = new QAction(text, window);
    action->setIconText(action->iconText()); // buttons keep it while menus name what it acts on
    action->setObjectName(QLatin1String(name));
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    setHelp(action, help);
    if (iconName != nullptr)
        action->setIcon(icon(QLatin1String(iconName)));
    return action;
}

QString tr(const char* text) {
    return QCoreApplication::translate("texloom::ui::ResultActions", text);
}

} // namespace

ResultActions::ResultActions(QWidget* window)
    : show(make(window, "showChosenResult", tr("&Show"), tr("Show the chosen result"))),
      restore(make(window, "restoreResult", tr("&Restore settings"),
                   tr("Bring the settings of the chosen result back into the form"), {}, "reset")),
      compare(make(window, "compareResults", tr("&Compare"),
                   tr("Look at up to 9 chosen results side by side, with their exemplars"), {}, "compare")),
      difference(make(window, "resultDifference", tr("&Differences…"),
                      tr("List the settings in which two chosen results differ; choose two first"))),
      pin(make(window, "pinResult", tr("&Pin"),
               tr("Keep the chosen results: pinned ones are never removed automatically"), Qt::Key_P, "pin")),
      rename(make(window, "renameResult", tr("Re&name"), tr("Give the chosen result a name of your own"),
                  Qt::Key_F2)),
      remove(make(window, "removeResult", tr("De&lete"), tr("Delete the chosen results"),
                  QKeySequence::Delete, "delete")),
      keep(make(window, "keepResult", tr("&Keep and go on"),
                tr("Pin the chosen result and choose the next one; 1 to 5 give it stars, 0 none"),
                Qt::Key_K)),
      limits(make(window, "resultLimits", tr("&Limits…"),
                  tr("Set how much memory and how much of the disk results may take"))) {
    pin->setCheckable(true);
    for (QAction* action : {pin, rename}) // what is shown is chosen, too
        action->setShortcutContext(Qt::WindowShortcut);
}

QMenu* ResultActions::makeMenu(QWidget* window) const {
    auto* menu = new QMenu(tr("&Results"), window);
    menu->addActions({show, restore, compare, difference});
    menu->addSeparator();
    menu->addActions({pin, keep, rename, remove});
    menu->addSeparator();
    menu->addAction(limits);
    return menu;
}

ResultPanel::ResultPanel(ResultHistory* history, const ResultActions& actions, QWidget* parent)
    : QWidget(parent), m_history(history), m_actions(actions), m_found(new ResultFilter(this)),
      m_search(new QLineEdit(this)), m_kind(new QComboBox(this)), m_list(new QListView), m_empty(new QLabel),
      m_usage(new QLabel(this)) {
    setObjectName(QStringLiteral("resultPanel"));
    m_found->setSourceModel(history);
    m_search->setObjectName(QStringLiteral("resultSearch"));
    m_search->setPlaceholderText(tr("Search results"));
    m_search->setAccessibleName(tr("Search results"));
    m_search->setClearButtonEnabled(true);
    m_search->setMaximumWidth(fontMetrics().averageCharWidth() * kSearchWidths);

    m_kind->setObjectName(QStringLiteral("resultKind"));
    m_kind->setAccessibleName(tr("Results shown"));
    m_kind->setToolTip(tr("Which results are shown; the others stay."));
    m_kind->addItem(tr("All"), static_cast<int>(ResultFilter::Kind::All));
    m_kind->addItem(tr("Without previews"), static_cast<int>(ResultFilter::Kind::WithoutPreviews));
    m_kind->addItem(tr("Pinned"), static_cast<int>(ResultFilter::Kind::Pinned));
    m_kind->addItem(tr("With stars"), static_cast<int>(ResultFilter::Kind::Starred));

    m_list->setObjectName(QStringLiteral("resultList"));
    m_list->setAccessibleName(tr("Results"));
    m_list->setModel(m_found);
    m_list->setItemDelegate(new ResultDelegate(m_list));
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setDragEnabled(true);
    m_list->setDragDropMode(QAbstractItemView::DragOnly);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setUniformItemSizes(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->addActions({m_actions.show, m_actions.restore, m_actions.compare, m_actions.difference,
                        m_actions.pin, m_actions.keep, m_actions.rename, m_actions.remove});
    m_list->installEventFilter(this);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);

    auto* column = new QVBoxLayout(this);
    column->addLayout(makeBar());
    column->addWidget(m_empty, 1);
    column->addWidget(m_list, 1);
    connectActions();
    explainEmpty();
    updateActions();
}

QLayout* ResultPanel::makeBar() {
    auto* bar = new FlowLayout;
    bar->addWidget(m_search);
    bar->addWidget(m_kind);
    for (QAction* action :
         {m_actions.restore, m_actions.compare, m_actions.difference, m_actions.pin, m_actions.remove}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        bar->addWidget(button);
    }
    bar->addWidget(m_usage);
    return bar;
}

void ResultPanel::connectActions() {
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_found->setFilterFixedString(text.trimmed());
        explainEmpty();
    });
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        QSettings().setValue(kKind, m_kind->currentData());
        m_found->setKind(static_cast<ResultFilter::Kind>(m_kind->currentData().toInt()));
        explainEmpty();
    });
    m_kind->setCurrentIndex(std::max(0, m_kind->findData(QSettings().value(kKind, 0).toInt())));
    connect(m_history, &ResultHistory::usageChanged, this, &ResultPanel::sayUsage);
    connect(m_found, &QAbstractItemModel::rowsInserted, this, &ResultPanel::explainEmpty);
    connect(m_found, &QAbstractItemModel::rowsRemoved, this, &ResultPanel::explainEmpty);
    connect(m_found, &QAbstractItemModel::modelReset, this, &ResultPanel::explainEmpty);
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ResultPanel::updateActions);
    connect(m_found, &QAbstractItemModel::dataChanged, this, &ResultPanel::updateActions);
    connect(m_list, &QListView::activated, m_actions.show, &QAction::trigger);
    connect(m_list, &QListView::clicked, this, [this] {
        if (m_actions.show->isEnabled()) // not while several are being chosen
            m_actions.show->trigger();
    });
    connect(m_actions.show, &QAction::triggered, this, [this] {
        if (const auto keys = selected(); !keys.empty())
            Q_EMIT showWanted(keys.front());
    });
    connect(m_actions.restore, &QAction::triggered, this, [this] {
        if (const auto keys = selected(); !keys.empty())
            Q_EMIT restoreWanted(keys.front());
    });
    connect(m_actions.compare, &QAction::triggered, this, [this] { Q_EMIT compareWanted(selected()); });
    connect(m_actions.difference, &QAction::triggered, this, &ResultPanel::showDifference);
    connect(m_actions.limits, &QAction::triggered, this, [this] { chooseLimits(*m_history, window()); });
    connect(m_actions.pin, &QAction::triggered, this, &ResultPanel::pinSelected);
    connect(m_actions.rename, &QAction::triggered, this, [this] {
        if (auto* dock = qobject_cast<QDockWidget*>(parentWidget())) {
            dock->show();
            dock->raise();
        }
        if (const auto keys = selected(); keys.size() == 1)
            m_list->edit(m_found->mapFromSource(m_history->indexOf(keys.front())));
    });
    connect(m_actions.remove, &QAction::triggered, this, &ResultPanel::removeSelected);
    connect(m_actions.keep, &QAction::triggered, this, &ResultPanel::keepAndGoOn);
    m_showTimer.setSingleShot(true);
    m_showTimer.setInterval(kShowPause);
    connect(&m_showTimer, &QTimer::timeout, m_actions.show, &QAction::trigger);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &ResultPanel::showSoon);
}

/// A result that was come to by keys is shown like one that was clicked.
void ResultPanel::showSoon() {
    if (!m_selecting && m_list->hasFocus() && QApplication::mouseButtons() == Qt::NoButton)
        m_showTimer.start();
}

bool ResultPanel::eventFilter(QObject* watched, QEvent* event) {
    const bool asked = event->type() == QEvent::ShortcutOverride, pressed = event->type() == QEvent::KeyPress;
    if (watched == m_list && (asked || pressed)) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool star = key->modifiers() == Qt::NoModifier && key->key() >= Qt::Key_0 &&
                          key->key() <= Qt::Key_0 + ResultEntry::kMostStars;
        if (star && asked) // the window's own shortcuts do not see it
            event->accept();
        else if (star)
            return starKey(key->key() - Qt::Key_0);
    }
    return QWidget::eventFilter(watched, event);
}

bool ResultPanel::starKey(int stars) {
    for (const std::string& key : selected())
        m_history->setStars(key, stars);
    return true;
}

void ResultPanel::keepAndGoOn() {
    for (const std::string& key : selected())
        m_history->setPinned(key, true);
    const QModelIndex next = m_found->index(m_list->currentIndex().row() + 1, 0);
    if (next.isValid())
        m_list->setCurrentIndex(next);
}

std::vector<std::string> ResultPanel::selected() const {
    QModelIndexList indexes = m_list->selectionModel()->selectedIndexes();
    std::sort(indexes.begin(), indexes.end(),
              [](const QModelIndex& a, const QModelIndex& b) { return a.row() < b.row(); });
    std::vector<std::string> keys;
    for (const QModelIndex& index : indexes)
        keys.push_back(index.data(ResultHistory::KeyRole).toString().toStdString());
    return keys;
}

void ResultPanel::select(const std::vector<std::string>& keys) {
    const QScopedValueRollback selecting(m_selecting, true);
    m_list->clearSelection();
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
        const QModelIndex index = m_found->mapFromSource(m_history->indexOf(*key));
        m_list->selectionModel()->select(index, QItemSelectionModel::Select);
        m_list->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
        m_list->scrollTo(index);
    }
}

void ResultPanel::showDifference() {
    const std::vector<std::string> keys = selected();
    if (keys.size() != 2)
        return;
    auto* dialog = new DifferenceDialog(*m_history->find(keys[1]), *m_history->find(keys[0]), window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void ResultPanel::pinSelected() {
    for (const std::string& key : selected())
        m_history->setPinned(key, m_actions.pin->isChecked());
}

void ResultPanel::removeSelected() {
    const std::vector<std::string> keys = selected();
    if (keys.empty())
        return;
    const auto pinned = std::count_if(
        keys.begin(), keys.end(), [this](const std::string& key) { return m_history->find(key)->pinned; });
    if (pinned == 0)
        return removeNow(keys);
    auto* question = new QMessageBox(
        QMessageBox::Question, tr("Delete pinned results?"),
        keys.size() == 1
            ? tr("“%1” is pinned. Delete it all the same?").arg(titleText(*m_history->find(keys.front())))
            : tr("%1 of the %2 chosen results are pinned. Delete all of them?").arg(pinned).arg(keys.size()),
        QMessageBox::Cancel, window());
    question->setObjectName(QStringLiteral("deletePinned"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    auto* yes = question->addButton(tr("&Delete"), QMessageBox::DestructiveRole);
    question->setDefaultButton(QMessageBox::Cancel);
    connect(yes, &QPushButton::clicked, this, [this, keys] { removeNow(keys); });
    question->open();
}

void ResultPanel::removeNow(const std::vector<std::string>& keys) {
    const QString what = keys.size() == 1
                             ? tr("“%1” was deleted.").arg(titleText(*m_history->find(keys.front())))
                             : tr("%1 results were deleted.").arg(keys.size());
    m_history->remove(keys);
    Q_EMIT removed(keys, what);
}

void ResultPanel::updateActions() {
    const std::vector<std::string> keys = selected();
    const bool one = keys.size() == 1;
    for (QAction* action : {m_actions.show, m_actions.restore, m_actions.rename})
        action->setEnabled(one);
    m_actions.difference->setEnabled(keys.size() == 2);
    m_actions.compare->setEnabled(!keys.empty() && keys.size() <= kMostCompared);
    m_actions.remove->setEnabled(!keys.empty());
    m_actions.pin->setEnabled(!keys.empty());
    m_actions.keep->setEnabled(!keys.empty());
    const auto pinned = [this](const std::string& key) {
        const ResultEntry* const entry = m_history->find(key);
        return entry != nullptr && entry->pinned;
    };
    m_actions.pin->setChecked(!keys.empty() && std::all_of(keys.begin(), keys.end(), pinned));
    nameTargets(keys);
}

/// The menus say what they would act on.
void ResultPanel::nameTargets(const std::vector<std::string>& keys) {
    const ResultEntry* const only = keys.size() == 1 ? m_history->find(keys.front()) : nullptr;
    if (only == nullptr) {
        const bool several = keys.size() > 1;
        m_actions.pin->setText(several ? tr("&Pin %1 results").arg(keys.size()) : tr("&Pin"));
        m_actions.rename->setText(tr("Re&name"));
        m_actions.remove->setText(several ? tr("De&lete %1 results").arg(keys.size()) : tr("De&lete"));
        return;
    }
    const int widest = fontMetrics().averageCharWidth() * kNameWidths;
    QString name = fontMetrics().elidedText(titleText(*only), Qt::ElideMiddle, widest);
    name.replace(QLatin1Char('&'), QStringLiteral("&&"));
    m_actions.pin->setText(tr("&Pin “%1”").arg(name));
    m_actions.rename->setText(tr("Re&name “%1”").arg(name));
    m_actions.remove->setText(tr("De&lete “%1”").arg(name));
}

void ResultPanel::explainEmpty() {
    const bool any = m_history->rowCount() > 0;
    const bool found = m_found->rowCount() > 0;
    const QString wanted = m_search->text().trimmed();
    m_empty->setText(
        any && wanted.isEmpty() ? tr("No result is of the kind chosen above; “All” shows the others.")
        : any ? tr("No result has “%1” in its name, method, exemplar, seed or notes.").arg(wanted)
              : tr("Every run is kept here with its settings. There is none yet: press Run."));
    m_empty->setVisible(!found);
    m_list->setVisible(found);
    m_search->setEnabled(any);
    sayUsage();
}

void ResultPanel::sayUsage() {
    const ResultStore& store = m_history->store();
    m_usage->setVisible(m_history->rowCount() > 0);
    m_usage->setText(tr("%1 in memory, %2 on disk")
                         .arg(QString::fromStdString(byteText(store.memoryUsed())),
                              QString::fromStdString(byteText(store.diskUsed()))));
    m_usage->setToolTip(
        tr("Up to %1 of results stay in memory and up to %2 on the disk; “Limits…” in the Results "
           "menu changes that.")
            .arg(QString::fromStdString(byteText(store.memoryBudget())),
                 QString::fromStdString(byteText(store.diskBudget()))));
}

} // namespace texloom::ui
