#pragma once

#include "ui/runs/result_history.h"

#include <QTimer>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QLayout;
class QLineEdit;
class QListView;
class QMenu;

namespace texloom::ui {

class ResultFilter;
/// What can be done with results; the menu and the panel's buttons show these.
struct ResultActions {
    /// Makes them as children of `window`.
    explicit ResultActions(QWidget* window);

    QAction* show;
    QAction* restore;
    QAction* compare;
    QAction* difference;
    QAction* pin;
    QAction* rename;
    QAction* remove;
    QAction* keep;
    QAction* limits;

    QMenu* makeMenu(QWidget* window) const;
};

/// The Results dock: a card for every run, a search, and what can be done with those that are chosen. A click
/// on a card shows its result, and a result that is shown is chosen, so that what P and F2 act on anywhere in
/// the window, and Del while the list has the focus, is what is seen, unless the user chose several.
class ResultPanel : public QWidget {
    Q_OBJECT

public:
    ResultPanel(ResultHistory* history, const ResultActions& actions, QWidget* parent = nullptr);

    /// Keys of the chosen results, in the order in which they are shown.
    std::vector<std::string> selected() const;
    /// Chooses these, and shows the first.
    void select(const std::vector<std::string>& keys);

Q_SIGNALS:
    void showWanted(const std::string& key);
    void restoreWanted(const std::string& key);
    void compareWanted(const std::vector<std::string>& keys);
    /// Results were taken off the list; the sentence says which.
    void removed(const std::vector<std::string>& keys, const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLayout* makeBar();
    void connectActions();
    void removeSelected();
    void removeNow(const std::vector<std::string>& keys);
    void pinSelected();
    void keepAndGoOn();
    bool starKey(int stars);
    void showSoon();
    void showDifference();
    void updateActions();
    void nameTargets(const std::vector<std::string>& keys);
    void explainEmpty();
    void sayUsage();

    ResultHistory* m_history;
    ResultActions m_actions;
    ResultFilter* m_found;
    QLineEdit* m_search;
    QComboBox* m_kind;
    QListView* m_list;
    QLabel* m_empty;
    QLabel* m_usage;
    QTimer m_showTimer; ///< while arrow keys go from one result to the next
    bool m_selecting = false;
};

} // namespace texloom::ui
