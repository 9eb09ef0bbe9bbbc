#pragma once

#include "core/io/recipe.h"

#include <QObject>

class QAction;

namespace texloom::ui {

class ExemplarStore;
class ResultView;
class RunDesk;

/// What is offered beside the result that is shown: to make one that wraps while it is shown repeated and
/// does not, and to run again what was made before its exemplar was edited. It tells the history, too, which
/// results that is true of.
class ResultOffers : public QObject {
    Q_OBJECT

public:
    /// @param repeat that shows pictures repeated.
    ResultOffers(RunDesk* desk, ExemplarStore* store, ResultView* view, QAction* repeat, QObject* parent);

    /// Whether an exemplar of a recipe is open, but in no state that the recipe means.
    bool madeBeforeEdits(const Recipe& recipe) const;

Q_SIGNALS:
    /// A run is wanted with these settings, on the exemplars as they are now.
    void runWanted(const texloom::Recipe& recipe, bool quick);

private:
    void refresh();
    void wrap();
    void rerun();

    RunDesk* m_desk;
    ExemplarStore* m_store;
    ResultView* m_view;
    QAction* m_repeat;
};

} // namespace texloom::ui
