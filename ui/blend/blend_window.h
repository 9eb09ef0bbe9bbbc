#pragma once

#include "core/match/blend.h"
#include "ui/blend/curve_viewer.h"
#include "ui/exemplar/named_image.h"
#include "ui/jobs/task.h"

#include <QDialog>
#include <QTimer>

#include <array>
#include <memory>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QMenu;
class QPushButton;
class QSlider;
class QSpinBox;

namespace texloom::ui {

class TaskBar;

/// Joins two images along a curve in several ways side by side (Raad, thesis 2016, figures 4.17 to 4.20). The
/// pictures follow every change in the background.
class BlendWindow : public QDialog {
    Q_OBJECT

public:
    /// The ways that can stand side by side.
    enum Way { CutWay, PoissonWay, LinearWay, ProgressiveWay, EdgeWay };
    static constexpr std::size_t kWays = 5;

    /// @param images to choose from, beside files; the first two are chosen.
    explicit BlendWindow(const std::vector<NamedImage>& images, QWidget* parent = nullptr);

    /// Adds an image to both lists and chooses it in one. @param which 0 or 1.
    void choose(int which, const NamedImage& image);
    CurveViewer* viewer(Way way) const { return m_cells[way].viewer; }
    /// What went wrong, or what to do first; empty if all is well.
    QString message() const;
    bool blending() const { return m_task.running() || m_soon.isActive(); }
    /// Writes one of the pictures. @param path its extension is the format.
    void save(Way way, const QString& path);

Q_SIGNALS:
    /// A picture was written that is wanted as an exemplar.
    void exemplarWanted(const QString& path);

private:
    struct Cell {
        BlendMethod method;
        Propagation propagation;
        CurveViewer* viewer;
        QCheckBox* shown;
    };
    using Pictures = std::array<std::shared_ptr<const DisplayPicture>, kWays>;

    QWidget* makeOptions();
    QWidget* makeImageRow(int which);
    QWidget* makePositionRow();
    void makeCells();
    QWidget* makeBottom();
    void addImage(const NamedImage& image);
    void openFile(int which);
    const NamedImage* chosen(int which) const;
    /// Whether both images are at hand; asks for one that is not.
    bool fetched();
    BlendOptions optionsOf(const Cell& cell) const;
    void showCurve();
    /// Keeps the band within what images with this shorter side allow.
    void limitBand(int shorterSide);
    void changed();
    void arrange();
    void offerToSave();
    void blendNow();
    void take(const Pictures& pictures);
    void say(const QString& text);
    void saveAs(Way way);

    std::vector<std::unique_ptr<NamedImage>> m_images;
    std::array<QComboBox*, 2> m_choice{};
    QComboBox* m_shape;
    QDoubleSpinBox* m_position;
    QSlider* m_slider;
    QSpinBox* m_band;
    QComboBox* m_color;
    QCheckBox* m_showCurve;
    QGridLayout* m_grid;
    std::array<Cell, kWays> m_cells{};
    QLabel* m_message;
    TaskBar* m_bar;
    QPushButton* m_save;
    QPushButton* m_use;
    QString m_written;
    QTimer m_soon;
    Task<Pictures> m_task;
    Task<QString> m_writing;
};

} // namespace texloom::ui
