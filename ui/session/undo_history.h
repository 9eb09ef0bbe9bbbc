#pragma once

#include "ui/exemplar/exemplar_store.h"
#include "ui/session/settings_state.h"

#include <QObject>

#include <functional>
#include <string>
#include <vector>

class QAction;
class QUndoStack;

namespace texloom::ui {

class ResultHistory;

/// Undo and redo of settings, exemplars in use, their edits, masks and companion maps, and of results that
/// were deleted, in one list. Changes of one slider that follow each other closely are one step.
class UndoHistory : public QObject {
    Q_OBJECT

public:
    /// @param read gives the settings as they stand; @param write shows others.
    UndoHistory(ExemplarStore* store, std::function<SettingsState()> read,
                std::function<void(const SettingsState&)> write, QObject* parent);

    /// Actions with keys; the caller puts them in menus.
    QAction* undoAction() const { return m_undo; }
    QAction* redoAction() const { return m_redo; }
    QUndoStack* stack() const { return m_stack; }

    /// To be called whenever a setting may have changed.
    void settingsEdited();
    /// While one of these exists, changes are not recorded for undo: they follow from something else.
    class Pause {
    public:
        explicit Pause(UndoHistory* history);
        ~Pause();
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        UndoHistory* m_history;
    };
    /// Results were taken off a history's list: undo puts them back. Their files go when that is no longer
    /// possible.
    void removed(ResultHistory* history, const std::vector<std::string>& keys);
    /// Does something that changes several settings as one step.
    void asOne(const std::function<void()>& change);
    /// Records what was done already in a tool of its own: undo calls `back`, redo `again`. What has one
    /// `key` and follows closely is one step; nothing is if it is empty.
    void done(const QString& what, const QString& key, const std::function<void()>& back,
              const std::function<void()>& again);
    /// Forgets everything, as another session opens.
    void clear();

private:
    void show(const SettingsState& state);

    ExemplarStore* m_store;
    std::function<SettingsState()> m_read;
    std::function<void(const SettingsState&)> m_write;
    QUndoStack* m_stack;
    QAction* m_undo;
    QAction* m_redo;
    SettingsState m_last;
    int m_paused = 0;
};

} // namespace texloom::ui
