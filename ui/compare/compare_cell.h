#pragma once

#include "ui/compare/compare_item.h"

#include <QWidget>

class QToolButton;

namespace texloom::ui {

class ElidedLabel;
class ImageViewer;

/// One picture of the grid with its label, and a button that takes its settings over.
class CompareCell : public QWidget {
    Q_OBJECT

public:
    explicit CompareCell(QWidget* parent = nullptr);

    void setItem(const CompareItem& item);
    /// Shows the item's picture in another look.
    void setPicture(std::shared_ptr<const DisplayPicture> picture);
    ImageViewer* viewer() const { return m_viewer; }

Q_SIGNALS:
    /// The button was pressed, or Return or a double click on the picture.
    void useWanted();
    /// It has the focus now.
    void entered();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    ElidedLabel* m_label;
    QToolButton* m_use;
    ImageViewer* m_viewer;
};

} // namespace texloom::ui
