#include "core/base/text.h"
#include "core/volume/volume_file.h"
#include "ui/common/message_bar.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/jobs/task_bar.h"
#include "ui/volume/box_dialog.h"
#include "ui/volume/slice_view.h"
#include "ui/volume/volume_page.h"

#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>

#include <filesystem>
#include <vector>

namespace texloom::ui {

namespace fs = std::filesystem;

QMenu* VolumePage::makeSaveMenu() {
    auto* menu = new QMenu(this);
    menu->addAction(tr("Slice as it is seen…"), this, &VolumePage::askForSlice)
        ->setObjectName(QStringLiteral("saveSlice"));
    menu->addAction(tr("Box of voxels…"), this, &VolumePage::askForBox)
        ->setObjectName(QStringLiteral("saveBox"));
    menu->addAction(tr("Mesh with colours…"), this, &VolumePage::askForMesh)
        ->setObjectName(QStringLiteral("saveMesh"));
    return menu;
}

void VolumePage::askForSlice() {
    const SliceView* const view = front();
    const QString path =
        askWhereToSave(this, tr("Save the slice %1").arg(view->title()), QStringLiteral("slice.png"),
                       tr("Pictures (*.png *.tif *.exr)"), {QStringLiteral("png")});
    if (!path.isEmpty())
        saveSlice(*view, path);
}

void VolumePage::askForBox() {
    BoxDialog dialog(m_solid->box(), this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const QString path = askWhereToSave(
        this, tr("Save a box of voxels"), QStringLiteral("box.json"),
        tr("Raw numbers and JSON (*.json);;Numbered slices (*.png *.tif *.exr)"), {QStringLiteral("json")});
    if (!path.isEmpty())
        saveBox(dialog.box(), path);
}

void VolumePage::askForMesh() {
    if (!m_solid->placed().mesh)
        return fail(tr("There is no mesh yet: choose one in the fourth view, under Mesh."));
    bool wanted = false;
    const double fineness = QInputDialog::getDouble(
        this, tr("Mesh with colours"),
        tr("Voxels from one vertex to the next, at most (0 leaves the mesh as it is):"), 1, 0, 1024, 1,
        &wanted);
    if (!wanted)
        return;
    const QString path =
        askWhereToSave(this, tr("Save the mesh with its colours"), QStringLiteral("solid.ply"),
                       tr("Meshes with colours (*.ply *.obj *.glb)"), {QStringLiteral("ply")});
    if (!path.isEmpty())
        saveMesh(path, fineness);
}

void VolumePage::saveSlice(const SliceView& view, const QString& path) {
    const auto [plane, size] = view.seen();
    write(path, tr("Writing a slice"), {toPath(path)},
          [volume = m_shown, plane = plane, size = size, path](JobContext& context) {
              return writeSlice(volume, plane, size, toPath(path), context);
          });
}

void VolumePage::saveBox(const Box& box, const QString& path) {
    write(path, tr("Writing a box of voxels"), volumeFiles(toPath(path), box.size.depth),
          [volume = m_shown, box, path](JobContext& context) {
              return writeBox(volume, box, toPath(path), context);
          });
}

void VolumePage::saveMesh(const QString& path, double fineness) {
    const PlacedMesh placed = m_solid->placed();
    if (!placed.mesh)
        return fail(tr("There is no mesh yet: choose one in the fourth view, under Mesh."));
    write(path, tr("Colouring a mesh"), {toPath(path)},
          [volume = m_shown, placed, fineness, path](JobContext& context) {
              return writeMeshColours(volume, placed, fineness, toPath(path), context);
          });
}

void VolumePage::write(const QString& path, const QString& what, const std::vector<fs::path>& files,
                       const Job<int>::Work& work) {
    if (!m_shown.source)
        return fail(tr("There is no volume to save anything of."));
    m_saving.start(
        {},
        [work, path, files, guard = SaveGuard()](JobContext& context) {
            guard.check(toPath(path), TR("part of the volume"), files);
            return work(context);
        },
        [this, path](int) {
            m_bar->end();
            m_message->dismiss();
            Q_EMIT saved(QFileInfo(path).path());
        },
        [this](const QString& why) {
            m_bar->end();
            fail(why);
        });
    m_bar->begin(what, [this] { return m_saving.progress(); });
}

} // namespace texloom::ui
