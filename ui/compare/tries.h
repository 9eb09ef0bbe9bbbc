#pragma once

#include "core/session/batch/join_input.h"
#include "core/session/run/run.h"

#include <QObject>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace texloom::ui {

class Comparisons;
class ExemplarStore;
class GridRun;
class RunDesk;

/// Runs made many at a time to be compared: one with each method, or one for each combination of some values.
class Tries : public QObject {
    Q_OBJECT

public:
    using Input = std::function<RunInput()>;

    /// Ids of methods by how well they suit the exemplar.
    using Order = std::function<std::vector<std::string>()>;

    /// @param input what a run would be given now. @param order those that suit the exemplar best, if that is
    /// known. @param window that actions and dialogs belong to.
    Tries(RunDesk* desk, const ExemplarStore* store, Comparisons* comparisons, Input input, Order order,
          QWidget* window);

    QAction* allAction() const { return m_all; }
    QAction* someAction() const { return m_some; }
    QAction* sweepAction() const { return m_sweep; }
    QMenu* exampleMenu() const { return m_examples; }
    /// Enables the actions as there is an exemplar to run methods on, and a run that can start.
    void updateActions();
    /// Makes a preview with every method and its default settings, the quickest first; those that suit the
    /// exemplar best are shown first.
    void tryAll();
    /// Stops a grid whose run is under way; see GridRun::stop().
    std::optional<int> stop();

Q_SIGNALS:
    /// Something could not be read; the sentence says why.
    void failed(const QString& sentence);
    /// Images are to be joined by a tool, as an example does.
    void joinsWanted(const std::vector<texloom::JoinInput>& joins);

private:
    void trySome();
    /// @param longest seconds that one of them may take.
    void tryMethods(const std::vector<std::string>& ids, bool quick, double longest);
    void startSweep();

    RunDesk* m_desk;
    const ExemplarStore* m_store;
    Comparisons* m_comparisons;
    Input m_input;
    Order m_order;
    QWidget* m_window;
    GridRun* m_grid;
    QAction* m_all;
    QAction* m_some;
    QAction* m_sweep;
    QMenu* m_examples;
};

} // namespace texloom::ui
