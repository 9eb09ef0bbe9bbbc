#pragma once

#include "core/tools/tool.h"
#include "ui/exemplar/edit_canvas.h"
#include "ui/exemplar/exemplar_store.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QLabel;
class QLayout;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace texloom::ui {

class EditPreview;
class ElidedLabel;
class ToolForm;
class ValueEditor;

/// The page on which the current exemplar is edited, by every tool there is, and parts of it are hidden from
/// methods that copy. Nothing here changes a file; every step shows in a list and can be undone.
class ExemplarEditor : public QWidget {
    Q_OBJECT

public:
    explicit ExemplarEditor(ExemplarStore* store, QWidget* parent = nullptr);

    EditCanvas* canvas() const { return m_canvas; }
    /// Chooses what the mouse does on the canvas: "look", "hide", "show", or the id of a tool with a frame.
    void setMode(const QString& mode);
    /// Says whether the method uses a mask.
    void setMaskUsed(bool used);

Q_SIGNALS:
    /// The user is through with it.
    void done();

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// What the mouse can do on the canvas, with the page of its settings.
    struct Mode {
        QString name;
        const Tool* tool; ///< whose frame it is; else null
        EditCanvas::Mode canvas;
        int page;
    };

    void makeModes(QWidget* row);
    void addMode(QWidget* row, const QString& title, const QString& help, Mode mode);
    QWidget* makePages();
    QWidget* makeLookPage();
    QWidget* makeMaskPage();
    void makeForms(QLayout* column);
    QWidget* makeListGroup();

    void showCurrent();
    void showPicture(const ExemplarEntry& entry, const ExemplarEdits& wanted);
    void showWithout(std::size_t index);
    void fillList(const ExemplarEdits& wanted, const ExemplarEdits& made);
    void removeEdit(int index);
    void append(const ExemplarEdit& edit);
    void adjust(const ToolForm* form);
    void hidePainted(const QImage& stroke);
    ExemplarEdits edits() const;
    void set(const ExemplarEdits& edits, const QString& what, const QString& key = {});

    ExemplarStore* m_store;
    EditCanvas* m_canvas;
    EditPreview* m_preview;
    ElidedLabel* m_title;
    QButtonGroup* m_buttons;
    std::vector<Mode> m_modes; ///< by the buttons' ids
    QStackedWidget* m_pages = nullptr;
    std::vector<ToolForm*> m_forms;
    QLabel* m_maskNote = nullptr;
    QPushButton* m_clearMask = nullptr;
    ValueEditor* m_brush = nullptr;
    QListWidget* m_list = nullptr;
    QPushButton* m_remove = nullptr;
    int m_shownId = 0;
    int m_beforeRequest = 0;
};

} // namespace texloom::ui
