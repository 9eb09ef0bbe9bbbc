#include "ui/session/undo_history.h"

#include "ui/runs/result_history.h"

#include <QAction>
#include <QElapsedTimer>
#include <QPointer>
#include <QUndoCommand>
#include <QUndoStack>

#include <utility>

namespace texloom::ui {

namespace {

/// Changes of one setting closer together than this are one step.
constexpr qint64 kOneGesture = 1000;
constexpr int kMostSteps = 200;
enum CommandId { SettingsId = 1, ExemplarId, TickId, ToolId };

/// From one state to another, by a function that shows either. Does nothing when it is pushed, since what it
/// stands for has been done.
template <class State> class StateCommand : public QUndoCommand {
public:
    using Show = std::function<void(const State&)>;

    StateCommand(int id, const QString& text, QString key, State before, State after, Show show)
        : QUndoCommand(text), m_id(id), m_key(std::move(key)), m_before(std::move(before)),
          m_after(std::move(after)), m_show(std::move(show)) {
        m_since.start();
    }

    int id() const override { return m_id; }
    void undo() override { m_show(m_before); }
    void redo() override {
        if (m_done)
            m_show(m_after);
        m_done = true;
    }
    bool mergeWith(const QUndoCommand* command) override {
        const auto* next = static_cast<const StateCommand*>(command);
        if (m_key.isEmpty() || next->m_key != m_key || m_since.elapsed() > kOneGesture)
            return false;
        m_after = next->m_after;
        m_since.start();
        return true;
    }

private:
    int m_id;
    QString m_key;
    State m_before, m_after;
    Show m_show;
    bool m_done = false;
    QElapsedTimer m_since;
};

/// Takes results off a history's list, which has been done when it is pushed.
class RemoveResults : public QUndoCommand {
public:
    RemoveResults(ResultHistory* history, std::vector<std::string> keys)
        : QUndoCommand(keys.size() == 1 ? UndoHistory::tr("Delete result")
                                        : UndoHistory::tr("Delete results")),
          m_history(history), m_keys(std::move(keys)) {}
    ~RemoveResults() override {
        if (m_history && m_removed)
            m_history->purge(m_keys);
    }

    void undo() override {
        m_removed = false;
        m_history->putBack(m_keys);
    }
    void redo() override {
        if (!m_removed)
            m_history->remove(m_keys);
        m_removed = true;
    }

private:
    QPointer<ResultHistory> m_history;
    std::vector<std::string> m_keys;
    bool m_removed = true;
};

QString nameOf(const QString& difference) {
    const QString group = difference.section(QLatin1Char('/'), 1, 1);
    if (group == QLatin1String("method"))
        return UndoHistory::tr("Method");
    if (group == QLatin1String("size"))
        return UndoHistory::tr("Size");
    if (group == QLatin1String("seed"))
        return UndoHistory::tr("Seed");
    if (group == QLatin1String("wrap"))
        return UndoHistory::tr("Wraps");
    if (group == QLatin1String("inputs"))
        return UndoHistory::tr("Input");
    return UndoHistory::tr("Settings");
}

} // namespace

UndoHistory::Pause::Pause(UndoHistory* history) : m_history(history) {
    if (m_history != nullptr)
        ++m_history->m_paused;
}

UndoHistory::Pause::~Pause() {
    if (m_history != nullptr && --m_history->m_paused == 0)
        m_history->m_last = m_history->m_read();
}

UndoHistory::UndoHistory(ExemplarStore* store, std::function<SettingsState()> read,
                         std::function<void(const SettingsState&)> write, QObject* parent)
    : QObject(parent), m_store(store), m_read(std::move(read)), m_write(std::move(write)),
      m_stack(new QUndoStack(this)), m_undo(m_stack->createUndoAction(parent, tr("&Undo"))),
      m_redo(m_stack->createRedoAction(parent, tr("&Redo"))), m_last(m_read()) {
    m_stack->setUndoLimit(kMostSteps);
    m_undo->setObjectName(QStringLiteral("undo"));
    m_undo->setShortcuts(QKeySequence::Undo);
    m_redo->setObjectName(QStringLiteral("redo"));
    m_redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    connect(m_store, &ExemplarStore::edited, this,
            [this](int id, const ExemplarState& before, const ExemplarState& after, const QString& what,
                   const QString& key) {
                const QString place = key.isEmpty() ? QString() : QStringLiteral("%1/%2").arg(id).arg(key);
                m_stack->push(new StateCommand<ExemplarState>(
                    ExemplarId, what, place, before, after,
                    [this, id](const ExemplarState& state) { m_store->restoreState(id, state); }));
            });
    connect(m_store, &ExemplarStore::ticked, this, [this](int id, bool checked, const QString& what) {
        m_stack->push(new StateCommand<bool>(TickId, what, {}, !checked, checked,
                                             [this, id](bool tick) { m_store->restoreChecked(id, tick); }));
    });
}

void UndoHistory::settingsEdited() {
    if (m_paused > 0)
        return;
    SettingsState now = m_read();
    const QString difference = m_last.difference(now);
    if (difference.isEmpty())
        return;
    m_stack->push(new StateCommand<SettingsState>(SettingsId, nameOf(difference), difference, m_last, now,
                                                  [this](const SettingsState& state) { show(state); }));
    m_last = std::move(now);
}

void UndoHistory::removed(ResultHistory* history, const std::vector<std::string>& keys) {
    m_stack->push(new RemoveResults(history, keys));
}

void UndoHistory::done(const QString& what, const QString& key, const std::function<void()>& back,
                       const std::function<void()>& again) {
    using Act = std::function<void()>;
    m_stack->push(new StateCommand<Act>(ToolId, what, key, back, again, [](const Act& act) { act(); }));
}

void UndoHistory::asOne(const std::function<void()>& change) {
    ++m_paused;
    change();
    --m_paused;
    settingsEdited();
}

void UndoHistory::show(const SettingsState& state) {
    const Pause pause(this);
    m_write(state);
}

void UndoHistory::clear() {
    m_stack->clear();
    m_last = m_read();
}

} // namespace texloom::ui
