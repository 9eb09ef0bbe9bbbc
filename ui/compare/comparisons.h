#pragma once

#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_item.h"

#include <QObject>

#include <memory>
#include <set>
#include <string>
#include <vector>

class QMenu;

namespace texloom::ui {

class CompareView;
class ExemplarStore;
class RunDesk;

/// Puts results of the history and exemplars that are open beside one another in the view of comparisons.
class Comparisons : public QObject {
    Q_OBJECT

public:
    /// @param window that the view and its actions belong to.
    Comparisons(RunDesk* desk, const ExemplarStore* store, QWidget* window);

    CompareView* view() const { return m_view; }
    QMenu* makeMenu();
    /// Shows results side by side, in the order in which they were made, with their exemplars if those are
    /// wanted at present.
    void compareChosen(const std::vector<std::string>& keys);
    /// The pictures of exemplars that are open, for the view.
    std::vector<CompareItem> exemplarItems(const std::set<int>& ids) const;
    /// Shows the result that is shown and the image that it was made from in one place, parted by a line.
    void compareWithInput();
    /// Writes what is compared as one picture.
    void saveSheet(const QString& path);
    /// Leaves the results that were compared for something else, and shows the view.
    void leaveFor();

Q_SIGNALS:
    /// The view holds what it is to show; bring it to the front.
    void ready();
    /// The settings of this result are to be taken over.
    void useWanted(const std::string& key);
    void told(const QString& sentence);
    void failed(const QString& sentence);

private:
    /// Results on their way into the view.
    struct Gathering;

    void compare(const std::vector<std::string>& keys, bool exemplar);
    void gather(const std::shared_ptr<Gathering>& gathering);
    void chooseMode(CompareMode mode);
    void writeContactSheet();
    std::set<int> exemplarsOf(const std::vector<std::string>& keys) const;
    std::set<int> exemplarsShown() const;
    void showExemplars(const std::set<int>& ids);
    void listExemplars();

    RunDesk* m_desk;
    const ExemplarStore* m_store;
    QWidget* m_window;
    CompareActions m_actions;
    CompareView* m_view;
    std::vector<std::string> m_compared; ///< results that were chosen to be compared
};

} // namespace texloom::ui
