#pragma once

#include "core/methods/method.h"
#include "core/session/run/exemplar_use.h"
#include "ui/exemplar/exemplar_store.h"

#include <QPoint>
#include <QWidget>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace texloom::ui {

class CompanionList;
class ElidedLabel;
class ImageViewer;
/// The left dock: the exemplar that is looked at, large enough to see where the result's pixels came from,
/// what is known of it, and the list of all that are open.
class ExemplarPanel : public QWidget {
    Q_OBJECT

public:
    /// The actions become the buttons under the list.
    ExemplarPanel(ExemplarStore* store, const QList<QAction*>& actions, QWidget* parent = nullptr);

    /// Shows what a run can use: check boxes if it learns from several exemplars, weights and masks if it
    /// heeds them.
    void setAbilities(const ExemplarUse& abilities);
    /// Marks the pixel that the result's pixel under the cursor came from, in the exemplar it belongs to.
    void showSource(const ExemplarEntry& entry, QPoint pixel);
    void hideSource();
    /// Shows the current exemplar in other colours, a map's legend; null: as it is.
    void setLegend(std::shared_ptr<const DisplayPicture> legend);
    ImageViewer* viewer() const { return m_viewer; }
    CompanionList* companions() const { return m_companions; }
    /// Asks for a mask file for the current exemplar.
    void chooseMask();

Q_SIGNALS:
    void hovered(QPoint pixel);
    void unhovered();

private:
    QWidget* makeDetails();
    void connectStore();
    void fillList();
    void fillRow(QListWidgetItem& item, const ExemplarEntry& entry) const;
    void showCurrent();
    void showDetails(const ExemplarEntry* entry);
    void showWeight(const ExemplarEntry* entry);
    void showLayer(const ExemplarEntry* entry);
    void showPicture(const ExemplarEntry* entry);

    ExemplarStore* m_store;
    ImageViewer* m_viewer;
    ElidedLabel* m_name;
    QLabel* m_facts;
    QComboBox* m_layer;
    QComboBox* m_space;
    ElidedLabel* m_maskName;
    QToolButton* m_setMask;
    QToolButton* m_clearMask;
    QWidget* m_maskRow;
    QDoubleSpinBox* m_weight;
    QFormLayout* m_form = nullptr;
    CompanionList* m_companions;
    QListWidget* m_list;
    std::shared_ptr<const DisplayPicture> m_legend;
    ExemplarUse m_abilities;
    bool m_filling = false;
};

} // namespace texloom::ui
