#pragma once

#include "ui/exemplar/edit_canvas.h"
#include "ui/exemplar/exemplar_store.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QGroupBox;
class QLabel;
class QListWidget;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace texloom::ui {

class ElidedLabel;
class ValueEditor;

/// "Turned by 12.5°": one edit in words.
QString editText(const ExemplarEdit& edit);

/// The page on which the current exemplar is edited: crop, turn, mirror, rectify, even out the light, hide
/// parts from methods that copy. Nothing here changes a file; every step shows in a list and can be undone.
class ExemplarEditor : public QWidget {
    Q_OBJECT

public:
    explicit ExemplarEditor(ExemplarStore* store, QWidget* parent = nullptr);

    EditCanvas* canvas() const { return m_canvas; }
    void setTool(EditCanvas::Tool tool);
    /// Says whether the method uses a mask.
    void setMaskUsed(bool used);

Q_SIGNALS:
    /// The user is through with it.
    void done();

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeToolRow();
    QWidget* makeToolPages();
    QWidget* makeCropPage();
    QWidget* makeRectifyPage();
    QWidget* makeMaskPage();
    QWidget* makeTurnGroup();
    QGroupBox* makeLightGroup();
    QWidget* makeListGroup();
    QSpinBox* makePixels(const QString& name, const QString& label);

    void showCurrent();
    void showBeforeLight();
    void fillList(const ExemplarEdits& edits);
    void showLight(const ExemplarEdits& edits);
    void showFrame();
    void takeCropFields();
    void takeCornerFields();
    void applyFrame();
    void turn(double degrees);
    void setAngle(double degrees);
    void mirror(FlipEdit::Axis axis);
    void lightEdited();
    void removeEdit(int index);
    void append(const ExemplarEdit& edit);
    ExemplarEdits edits() const;
    void set(const ExemplarEdits& edits, const QString& what, const QString& key = {});

    ExemplarStore* m_store;
    EditCanvas* m_canvas;
    ElidedLabel* m_title;
    QButtonGroup* m_tools;
    QStackedWidget* m_pages = nullptr;
    QSpinBox *m_cropX = nullptr, *m_cropY = nullptr, *m_cropWidth = nullptr, *m_cropHeight = nullptr;
    std::array<QSpinBox*, 8> m_corners{};
    QLabel* m_maskNote = nullptr;
    QPushButton* m_clearMask = nullptr;
    ValueEditor *m_angle = nullptr, *m_brush = nullptr;
    QGroupBox* m_light = nullptr;
    ValueEditor *m_model = nullptr, *m_width = nullptr, *m_order = nullptr, *m_strength = nullptr;
    QLabel *m_widthLabel = nullptr, *m_orderLabel = nullptr;
    QCheckBox* m_withoutLight = nullptr;
    QListWidget* m_list = nullptr;
    QPushButton* m_remove = nullptr;
    int m_shownId = 0;
    int m_beforeRequest = 0;
    bool m_filling = false;
};

} // namespace texloom::ui
