#pragma once

#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_item.h"

#include <QWidget>

#include <string>
#include <vector>

class QLabel;
class QScrollArea;
class QStackedWidget;

namespace texloom::ui {

class CompareCell;
class ImageViewer;
class ViewLink;
class WipeViewer;

/// Pictures beside one another: as a grid, or two of them in one place with a wipe, in turn, or as their
/// difference. Zoom, pan, repetition, exposure and channel are those of all of them.
class CompareView : public QWidget {
    Q_OBJECT

public:
    explicit CompareView(const CompareActions& actions, QWidget* parent = nullptr);

    /// Shows these. @param columns of the grid; 0 for a grid about as wide as high.
    /// @param heading what they have in common, for a contact sheet.
    void setItems(std::vector<CompareItem> items, int columns = 0, const QString& heading = {});
    /// Another picture, label or message for one of them.
    void setItem(int index, const CompareItem& item);
    const std::vector<CompareItem>& items() const { return m_items; }
    int columns() const { return m_columns; }
    const QString& heading() const { return m_heading; }
    /// Number of pictures that are there.
    int pictures() const;

    CompareMode mode() const { return m_mode; }
    /// Choosing Toggle again shows the other picture.
    void setMode(CompareMode mode);
    CompareBar* bar() const { return m_bar; }
    ImageViewer* viewer(int index) const;
    /// The viewer of all ways but the grid.
    WipeViewer* single() const { return m_single; }
    /// The viewer that keys act on.
    ImageViewer* front() const;

Q_SIGNALS:
    /// Other pictures took the place of all.
    void replaced();
    /// The cursor is over a pixel of a picture; its values as text.
    void hovered(const QString& label, QPoint pixel, const QString& values);
    void unhovered();
    /// The settings of this result are to be taken over.
    void useWanted(const std::string& key);

private:
    void makeChannelKeys();
    void fillGrid();
    void look();
    void lookAt(int index);
    void entered(int index);
    void hover(int index, QPoint pixel);
    void endHover();
    void showPair();
    void showDifference();
    std::shared_ptr<const DisplayPicture> shownPicture(int index) const;

    CompareActions m_actions;
    CompareBar* m_bar;
    QStackedWidget* m_stack;
    QScrollArea* m_scroll;
    QLabel* m_empty;
    WipeViewer* m_single;
    ViewLink* m_link;
    std::vector<CompareItem> m_items;
    std::vector<CompareCell*> m_cells;
    std::vector<std::shared_ptr<const DisplayPicture>> m_looked; ///< in the bar's look, where it is not plain
    CompareMode m_mode = CompareMode::Grid;
    int m_columns = 1;
    QString m_heading;
    int m_last = 0;       ///< the cell that had the focus last
    bool m_other = false; ///< whether Toggle shows the second
    int m_request = 0;
    int m_lookRequest = 0;
};

} // namespace texloom::ui
