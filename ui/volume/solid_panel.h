#pragma once

#include "ui/jobs/task.h"
#include "ui/volume/solid_view.h"
#include "ui/volume/volume_cursor.h"
#include "ui/volume/volume_files.h"

#include <QWidget>

#include <array>
#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;
class QStackedWidget;

namespace texloom::ui {

class SliceView;

/// The fourth view of a volume: an oblique slice, a block with what the crosshair cuts away, or a mesh that
/// takes its colours from the volume, each with its settings.
class SolidPanel : public QWidget {
    Q_OBJECT

public:
    enum View { Oblique, Block, OnMesh };

    /// @param cursor must stay.
    explicit SolidPanel(VolumeCursor* cursor, QWidget* parent = nullptr);
    ~SolidPanel() override;

    void setSource(const std::shared_ptr<const VolumeSource>& source);
    void setView(View view);
    View view() const;

    SliceView* oblique() const { return m_oblique; }
    SolidView* block() const { return m_block; }
    SolidView* onMesh() const { return m_mesh; }
    /// The widget of the view that is shown.
    QWidget* current() const;

    /// Shows the volume on a mesh of a file; what is shown stays where it cannot be read.
    void openMesh(const QString& path);
    /// The file that the mesh was read from; empty if none.
    QString meshFile() const { return m_meshes.file; }
    /// The mesh as it is in its file, and how the volume lies in it; no mesh while there is none.
    PlacedMesh placed() const;
    /// The voxels of the block.
    const Box& box() const { return m_box; }

Q_SIGNALS:
    void failed(const QString& sentence);
    void enlargeWanted();

private:
    /// A mesh as it is drawn, and as it was read.
    struct Meshes {
        std::shared_ptr<const RenderMesh> drawn;
        std::shared_ptr<const Mesh> read;
        QString file = {}; ///< empty for one of no file
    };

    QWidget* makeObliqueFields();
    QWidget* makeBlockFields();
    QWidget* makeMeshFields();
    void makeLight();
    void shapeChosen();
    void take(const Meshes& meshes);
    void showBlock();
    void showMesh();
    void moveCut(const Eigen::Vector3d& voxels);
    void moveTexture(const Eigen::Vector3d& voxels);
    SolidPlacement placement() const;

    VolumeCursor* m_cursor;
    QComboBox* m_views;
    QStackedWidget* m_fields;
    QStackedWidget* m_stack;
    SliceView* m_oblique;
    SolidView* m_block;
    SolidView* m_mesh;
    QDoubleSpinBox* m_turn;
    QDoubleSpinBox* m_tilt;
    QComboBox* m_cut;
    QSpinBox* m_side;
    QComboBox* m_shape;
    QSpinBox* m_scale; ///< voxels along the mesh's longest side
    std::array<QDoubleSpinBox*, 3> m_angles;
    Box m_box;
    Eigen::Vector3d m_cutLeft = Eigen::Vector3d::Zero();   ///< moved by less than a voxel so far
    Eigen::Vector3d m_textureAt = Eigen::Vector3d::Zero(); ///< the voxel in the mesh's middle
    Meshes m_meshes;
    int m_lastShape = 1;
    Task<Meshes> m_meshing;
    Task<std::shared_ptr<const Environment>> m_lighting;
};

} // namespace texloom::ui
