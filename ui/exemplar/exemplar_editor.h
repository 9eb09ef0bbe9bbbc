#pragma once

#include "ui/exemplar/edit_canvas.h"
#include "ui/exemplar/exemplar_store.h"

#include <QWidget>

class QButtonGroup;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace texloom::ui {

class ElidedLabel;
class LightGroup;
class ValueEditor;

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
    QWidget* makeMaskPage();
    QWidget* makeTurnGroup();
    QWidget* makeListGroup();

    void showCurrent();
    void showBeforeLight();
    void fillList(const ExemplarEdits& edits);
    void applyFrame(const ExemplarEdit& edit);
    void removeEdit(int index);
    void append(const ExemplarEdit& edit);
    ExemplarEdits edits() const;
    void set(const ExemplarEdits& edits, const QString& what, const QString& key = {});

    ExemplarStore* m_store;
    EditCanvas* m_canvas;
    ElidedLabel* m_title;
    QButtonGroup* m_tools;
    QStackedWidget* m_pages = nullptr;
    QLabel* m_maskNote = nullptr;
    QPushButton* m_clearMask = nullptr;
    ValueEditor *m_angle = nullptr, *m_brush = nullptr;
    LightGroup* m_light = nullptr;
    QListWidget* m_list = nullptr;
    QPushButton* m_remove = nullptr;
    int m_shownId = 0;
    int m_beforeRequest = 0;
};

} // namespace texloom::ui
