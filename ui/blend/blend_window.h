#pragma once

#include "core/tools/tool.h"
#include "ui/blend/curve_viewer.h"
#include "ui/blend/region_viewer.h"
#include "ui/exemplar/named_image.h"
#include "ui/jobs/task.h"

#include <QDialog>
#include <QString>
#include <QTimer>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGridLayout;
class QLabel;
class QPushButton;

namespace texloom::ui {

class TaskBar;
class ValueEditor;

/// Where the folder of pictures that are opened and saved here is kept.
inline const QString kBlendFolder = QStringLiteral("folders/blend");

/// Joins two images by a tool, in all the ways that it declares side by side (as Raad, thesis 2016,
/// figures 4.17 to 4.20). The pictures follow every change in the background.
class BlendWindow : public QDialog {
    Q_OBJECT

public:
    /// @param images to choose from, beside files; the first two that can be joined are chosen.
    explicit BlendWindow(const std::vector<NamedImage>& images, QWidget* parent = nullptr);

    /// Adds an image to both lists and chooses it in one. @param which 0 or 1.
    void choose(int which, const NamedImage& image);
    /// Takes another tool that joins.
    void setTool(const Tool& tool);
    const Tool& tool() const { return *m_tool; }
    /// Sets the parameters that no way sets by itself.
    void setValues(const Values& values);
    /// The picture of one of the tool's ways, by number.
    ImageViewer* viewer(std::size_t way) const { return m_cells.at(way).viewer; }
    /// What went wrong, or what to do first; empty if all is well.
    QString message() const;
    bool blending() const { return m_task.running() || m_soon.isActive(); }
    /// Takes what was painted as the region of the second image. @param selection of that image's size, as
    /// selections has it.
    void setRegion(const Image& selection);
    /// Writes one of the pictures. @param path its extension is the format.
    void save(std::size_t way, const QString& path);

Q_SIGNALS:
    /// A picture was written that is wanted as an exemplar.
    void exemplarWanted(const QString& path);

private:
    /// One way of the tool: its title, what it sets, and where its picture is.
    struct Cell {
        QString title;
        Values values;
        ImageViewer* viewer;
        QCheckBox* shown;
    };
    /// A parameter that is the same for all ways.
    struct Row {
        const Param* param;
        ValueEditor* editor;
    };
    using Pictures = std::vector<std::shared_ptr<const DisplayPicture>>;
    using Shared = std::shared_ptr<const Image>;

    QWidget* makeOptions();
    QWidget* makeImageRow(int which);
    void makeRows();
    void makeCells();
    void addCell(const QString& title, const QString& help, const Values& values);
    ImageViewer* makeViewer();
    void paintRegion();
    void keepRegionOf(const Shared& second);
    void showRegion();
    QWidget* makeBottom();
    void fillSaveMenu();
    void addImage(const NamedImage& image);
    void openFile(int which);
    const NamedImage* chosen(int which) const;
    bool twoChosen();
    /// Whether both images are at hand; asks for one that is not.
    bool fetched();
    ValueEditor* editorOf(std::string_view name) const;
    Values settingsOf(const Cell& cell) const;
    void showCurve();
    void showHandle();
    /// Keeps values within what images with this shorter side allow.
    void limitRows(int shorterSide);
    void changed();
    void arrange();
    void offerToSave();
    void blendNow();
    void take(const Pictures& pictures, const QString& note);
    void say(const QString& text);
    void saveAs(std::size_t way);

    const Tool* m_tool;
    std::vector<std::unique_ptr<NamedImage>> m_images;
    std::array<QComboBox*, 2> m_choice{};
    QComboBox* m_tools;
    QFormLayout* m_rowForm = nullptr;
    std::vector<Row> m_rows;
    QCheckBox* m_showHandle;
    QWidget* m_ways;
    QGridLayout* m_grid;
    std::vector<Cell> m_cells;
    QLabel* m_message;
    TaskBar* m_bar;
    QPushButton* m_paint;
    QPushButton* m_save;
    QPushButton* m_use;
    QString m_written;
    std::shared_ptr<const MovableRegion> m_region; ///< null until it is known
    Shared m_regionOf;                             ///< the image that it is of
    QTimer m_soon;
    Task<Pictures> m_task;
    Task<QString> m_writing;
};

} // namespace texloom::ui
