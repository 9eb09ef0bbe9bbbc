#pragma once

#include "core/render/environment.h"
#include "core/render/render_mesh.h"
#include "core/session/run/result_material.h"
#include "ui/jobs/task.h"
#include "ui/runs/run_pictures.h"

#include <QWidget>

#include <functional>
#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSpinBox;

namespace texloom::ui {

class MaterialView;
class MessageBar;
class TaskBar;

/// The tab that shows a result as a material: on a shape or the user's mesh, in a light of choice, also while
/// a run is under way. BasicShape, light and how the maps lie are kept for the next start.
class MaterialPage : public QWidget {
    Q_OBJECT

public:
    explicit MaterialPage(QWidget* parent = nullptr);
    ~MaterialPage() override;

    /// Shows a run's pictures, under way or finished; the maps only once it is finished.
    void showPictures(const RunPictures& pictures);

    MaterialView* view() const { return m_view; }
    /// Why something could not be shown; empty if nothing.
    QString message() const;
    /// Shows the material on a mesh from a file.
    void openMesh(const QString& path);
    /// Lights it by a panorama from a file.
    void openPanorama(const QString& path);
    /// Writes what is shown, at this size, as a picture. @param path says in which format.
    void savePicture(const QString& path);
    /// Writes a turn around the shape as numbered pictures.
    void saveTurntable(const QString& folder, int pictures, int side);

Q_SIGNALS:
    /// Files were written, to this folder.
    void saved(const QString& folder);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeFields();
    QGridLayout* layOutFields();
    void connectFields();
    void takeMaterial();
    void shapeChosen();
    void lightChosen();
    void showFields();
    void lookEdited();
    void askForPicture();
    void askForTurntable();
    void fail(const QString& sentence);
    void restore();
    void keep() const;

    std::function<Material()> m_source; ///< of what is to be shown next; empty if it is shown
    QComboBox* m_shape;
    QComboBox* m_light;
    QComboBox* m_shown;
    QComboBox* m_backdrop;
    QSpinBox* m_repeat;
    QDoubleSpinBox* m_relief;
    QDoubleSpinBox* m_exposure;
    QDoubleSpinBox* m_lightTurn;
    MessageBar* m_message;
    MaterialView* m_view;
    TaskBar* m_bar;
    Task<std::shared_ptr<const MaterialTexture>> m_taking;
    Task<std::shared_ptr<const RenderMesh>> m_meshing;
    Task<std::shared_ptr<const Environment>> m_lighting;
    QString m_meshFile, m_lightFile; ///< empty where they come from no file
    Task<int> m_saving;
};

} // namespace texloom::ui
