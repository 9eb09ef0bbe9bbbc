#pragma once

#include "ui/jobs/task.h"
#include "ui/volume/solid_panel.h"
#include "ui/volume/volume_cursor.h"
#include "ui/volume/volume_files.h"

#include <QPointer>
#include <QWidget>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QMenu;
class QSpinBox;
class QToolButton;

namespace texloom::ui {

class ElidedLabel;
class MessageBar;
class SliceView;
class TaskBar;

/// A volume that can be looked at, under the name that it is chosen by.
struct NamedVolume {
    QString name;
    SourceWithRecipe volume;
    std::vector<std::filesystem::path> files = {}; ///< that it was read from
};

/// The tab that shows volumes: three slices with one crosshair and a fourth view, which may be an oblique
/// slice, a block that is cut open at the crosshair, or a mesh with the volume's colours. One of the views
/// may have all the room. Slices, boxes and coloured meshes are saved from here.
class VolumePage : public QWidget {
    Q_OBJECT

public:
    explicit VolumePage(QWidget* parent = nullptr);
    ~VolumePage() override;

    /// The volumes of the result that is shown, the first of them in front; one of a file stays beside them.
    void setVolumes(std::vector<NamedVolume> volumes);
    /// Whether there is nothing to look at.
    bool empty() const { return m_choice.empty(); }
    /// Looks at the solid of a generator, or a volume, in a file; what is shown stays where it cannot be
    /// read.
    void openFile(const QString& path);

    VolumeCursor* place() { return &m_cursor; }
    SliceView* slice(Axis axis) const { return m_slices[static_cast<std::size_t>(axis)]; }
    SolidPanel* solid() const { return m_solid; }
    const std::vector<NamedVolume>& volumes() const { return m_choice; }
    /// Why something could not be done; empty if nothing.
    QString message() const;
    /// "x −3 · y 0 · z 12 · …": what is under the mouse, or else under the crosshair.
    QString readout() const;
    /// Gives a view all the room, or all of them their part; null for all.
    void enlarge(QWidget* view);

    void saveSlice(const SliceView& view, const QString& path);
    void saveBox(const Box& box, const QString& path);
    /// @param fineness see writeMeshColours()
    void saveMesh(const QString& path, double fineness);

Q_SIGNALS:
    /// A file was opened and is shown.
    void opened();
    /// It was not, for this reason.
    void refused(const QString& sentence);
    /// Whether there is anything to look at may have changed.
    void changed();
    /// Files were written, to this folder.
    void saved(const QString& folder);

private:
    void makeFields();
    QMenu* makeSaveMenu();
    void layOut();
    void connectViews();
    void fillChoice(int chosen);
    void choose(int index);
    void fitFields();
    void showCross();
    void showPlace(const Eigen::Vector3d& space, const QString& values);
    void askForSlice();
    void askForBox();
    void askForMesh();
    /// @param files that `work` writes, for what the user called `path`.
    void write(const QString& path, const QString& what, const std::vector<std::filesystem::path>& files,
               const Job<int>::Work& work);
    void fail(const QString& sentence);
    SliceView* front() const;

    VolumeCursor m_cursor;
    std::vector<NamedVolume> m_choice;
    std::optional<NamedVolume> m_ofFile;
    SourceWithRecipe m_shown;
    bool m_hovering = false; ///< the mouse is at a place in a slice
    QLabel* m_choiceLabel;
    QComboBox* m_choiceBox;
    std::array<QSpinBox*, 3> m_coordinates;
    QToolButton* m_all;
    QToolButton* m_save;
    MessageBar* m_message;
    QGridLayout* m_grid = nullptr;
    std::array<SliceView*, 3> m_slices; ///< by Axis
    SolidPanel* m_solid;
    ElidedLabel* m_readout;
    TaskBar* m_bar;
    QPointer<SliceView> m_last; ///< the slice that had the focus last
    Task<NamedVolume> m_opening;
    Task<int> m_saving;
};

} // namespace texloom::ui
