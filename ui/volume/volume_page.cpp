#include "ui/volume/volume_page.h"

#include "core/generator/generator_source.h"
#include "core/session/run/asset_file.h"
#include "core/volume/volume_file.h"
#include "ui/common/elided_label.h"
#include "ui/common/message_bar.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/jobs/task_bar.h"
#include "ui/volume/slice_view.h"

#include <QApplication>
#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

using Eigen::Vector3d;

constexpr auto kMostVoxel = static_cast<std::int64_t>(VolumeCursor::kFarthest); ///< of coordinates

NamedVolume volumeIn(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    const auto file = toPath(path);
    if (file.extension() == usualExtension(AssetKind::Model)) {
        const Model model = readModel(file);
        return {name, {solidOf(model, 0), model.recipe}, {file}};
    }
    return {name,
            {std::get<std::shared_ptr<const VolumeSource>>(readAsset(AssetKind::Volume, file, {})), {}},
            filesOfVolume(file)};
}

QString number(double value) {
    const bool whole = value == std::round(value);
    return QString::number(value, 'f', whole ? 0 : 1).replace(QLatin1Char('-'), QChar(0x2212));
}

} // namespace

VolumePage::VolumePage(QWidget* parent)
    : QWidget(parent), m_choiceLabel(new QLabel(tr("Volume"), this)),
      m_choiceBox(new QComboBox(this)), m_coordinates{new QSpinBox(this), new QSpinBox(this),
                                                      new QSpinBox(this)},
      m_all(new QToolButton(this)), m_save(new QToolButton(this)),
      m_message(new MessageBar(this)), m_slices{new SliceView(Axis::X, &m_cursor, this),
                                                new SliceView(Axis::Y, &m_cursor, this),
                                                new SliceView(Axis::Z, &m_cursor, this)},
      m_solid(new SolidPanel(&m_cursor, this)), m_readout(new ElidedLabel(this)), m_bar(new TaskBar(this)) {
    setObjectName(QStringLiteral("volumePage"));
    m_message->dismiss();
    makeFields();
    layOut();
    connectViews();
    setFocusProxy(slice(Axis::Z));
    FilesInUse::all().add(this, [this](OutputGuard& guard) {
        if (m_ofFile)
            guard.reads(m_ofFile->files, TR("the volume that is open"));
        if (!m_solid->meshFile().isEmpty())
            guard.reads(toPath(m_solid->meshFile()), TR("the mesh that the volume is shown on"));
    });
    setVolumes({});
}

VolumePage::~VolumePage() = default;

void VolumePage::makeFields() {
    m_choiceBox->setObjectName(QStringLiteral("volumeChoice"));
    m_choiceBox->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    constexpr int kShownLetters = 14;
    m_choiceBox->setMinimumContentsLength(kShownLetters);
    m_choiceLabel->setBuddy(m_choiceBox);
    connect(m_choiceBox, &QComboBox::currentIndexChanged, this, &VolumePage::choose);
    const std::array<QString, 3> names = {QStringLiteral("sliceX"), QStringLiteral("sliceY"),
                                          QStringLiteral("sliceZ")};
    for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
        QSpinBox* const box = m_coordinates.at(i);
        box->setObjectName(names.at(i));
        box->setToolTip(tr("The voxel under the crosshair"));
        box->setKeyboardTracking(false);
        connect(box, &QSpinBox::valueChanged, this, [this] {
            const Vector3d to(m_coordinates[0]->value(), m_coordinates[1]->value(),
                              m_coordinates[2]->value());
            // What is typed in is to be seen.
            m_cursor.setMiddle(m_cursor.middle() + to - m_cursor.cross());
            m_cursor.setCross(to);
        });
    }
    m_all->setObjectName(QStringLiteral("volumeAll"));
    m_all->setText(tr("All views"));
    m_all->setToolTip(tr("Gives each view its part of the room again"));
    m_all->setEnabled(false);
    connect(m_all, &QToolButton::clicked, this, [this] { enlarge(nullptr); });
    m_save->setObjectName(QStringLiteral("volumeSave"));
    m_save->setText(tr("Save"));
    m_save->setPopupMode(QToolButton::InstantPopup);
    m_save->setMenu(makeSaveMenu());
}

void VolumePage::layOut() {
    auto* top = new QHBoxLayout;
    top->addWidget(m_choiceLabel);
    top->addWidget(m_choiceBox, 1);
    for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
        auto* label = new QLabel(QString(QStringLiteral("xyz").at(static_cast<int>(i))), this);
        label->setBuddy(m_coordinates.at(i));
        top->addWidget(label);
        top->addWidget(m_coordinates.at(i));
    }
    top->addStretch();
    top->addWidget(m_all);
    top->addWidget(m_save);
    m_grid = new QGridLayout;
    const int space = std::max(2, fontMetrics().height() / 5);
    m_grid->setSpacing(space);
    // Slices side by side or one above the other have an axis in common.
    m_grid->addWidget(slice(Axis::Z), 0, 0);
    m_grid->addWidget(slice(Axis::X), 0, 1);
    m_grid->addWidget(slice(Axis::Y), 1, 0);
    m_grid->addWidget(m_solid, 1, 1);
    enlarge(nullptr);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, space, 0, 0);
    rows->setSpacing(space);
    rows->addLayout(top);
    rows->addWidget(m_message);
    rows->addLayout(m_grid, 1);
    rows->addWidget(m_readout);
    rows->addWidget(m_bar);
}

void VolumePage::connectViews() {
    const std::array<QString, 3> names = {QStringLiteral("sliceYZ"), QStringLiteral("sliceXZ"),
                                          QStringLiteral("sliceXY")};
    for (std::size_t i = 0; i < m_slices.size(); ++i) {
        SliceView* const view = m_slices.at(i);
        view->setObjectName(names.at(i));
        view->setToolTip(tr("Click to bring the crosshair here; drag its lines to move it, and the rest to "
                            "move along. The wheel zooms, with Ctrl it steps through the volume, like Page "
                            "Up and Page Down. Double click gives it all the room."));
        connect(view, &SliceView::enlargeWanted, this,
                [this, view] { enlarge(m_all->isEnabled() ? nullptr : view); });
    }
    m_solid->oblique()->setToolTip(tr("Drag to move along, with Shift to turn the slice; a click brings the "
                                      "crosshair here. Double click gives it all the room."));
    connect(m_solid, &SolidPanel::enlargeWanted, this,
            [this] { enlarge(m_all->isEnabled() ? nullptr : m_solid); });
    connect(m_solid, &SolidPanel::failed, this, &VolumePage::fail);
    for (SliceView* view : {m_slices[0], m_slices[1], m_slices[2], m_solid->oblique()}) {
        connect(view, &SliceView::failed, this, &VolumePage::fail);
        connect(view, &SliceView::hovered, this, [this](const Vector3d& space, const QString& values) {
            m_hovering = true;
            showPlace(space, values);
        });
        connect(view, &SliceView::unhovered, this, [this] {
            m_hovering = false;
            showCross();
        });
        connect(view, &SliceView::shown, this, [this] {
            if (!m_hovering)
                showCross();
        });
    }
    connect(&m_cursor, &VolumeCursor::crossMoved, this, &VolumePage::showCross);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_saving.cancel();
        m_bar->end();
    });
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (auto* view = qobject_cast<SliceView*>(now); view != nullptr && isAncestorOf(view))
            m_last = view;
    });
}

void VolumePage::setVolumes(std::vector<NamedVolume> volumes) {
    const bool ofResult = !volumes.empty();
    const bool fileShown = m_ofFile && m_shown.source == m_ofFile->volume.source;
    m_choice = std::move(volumes);
    if (m_ofFile)
        m_choice.push_back(*m_ofFile);
    if (!ofResult && fileShown) { // nothing changes for who looks at it
        fillChoice(static_cast<int>(m_choice.size()) - 1);
    } else {
        fillChoice(m_choice.empty() ? -1 : 0);
        choose(m_choiceBox->currentIndex());
    }
    Q_EMIT changed();
}

void VolumePage::fillChoice(int chosen) {
    const QSignalBlocker quiet(m_choiceBox);
    m_choiceBox->clear();
    for (const NamedVolume& volume : m_choice)
        m_choiceBox->addItem(volume.name);
    m_choiceBox->setCurrentIndex(chosen);
    m_choiceBox->setVisible(m_choice.size() > 1);
    m_choiceLabel->setVisible(m_choice.size() > 1);
}

void VolumePage::choose(int index) {
    m_shown = index < 0 ? SourceWithRecipe{} : m_choice.at(static_cast<std::size_t>(index)).volume;
    m_save->setEnabled(m_shown.source != nullptr);
    m_message->dismiss();
    for (SliceView* view : m_slices)
        view->setSource(nullptr);
    m_solid->setSource(nullptr);
    if (m_shown.source)
        m_cursor.reset(m_shown.source->bounds());
    fitFields();
    for (SliceView* view : m_slices)
        view->setSource(m_shown.source);
    m_solid->setSource(m_shown.source);
    showCross();
}

void VolumePage::fitFields() {
    const std::optional<Box>& bounds = m_cursor.bounds();
    const std::array<std::int64_t, 3> first = bounds ? std::array{bounds->x, bounds->y, bounds->z}
                                                     : std::array{-kMostVoxel, -kMostVoxel, -kMostVoxel},
                                      last = bounds ? std::array{bounds->endX() - 1, bounds->endY() - 1,
                                                                 bounds->endZ() - 1}
                                                    : std::array{kMostVoxel, kMostVoxel, kMostVoxel};
    for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
        const QSignalBlocker quiet(m_coordinates.at(i));
        const auto within = [](std::int64_t value) {
            return static_cast<int>(std::clamp<std::int64_t>(value, -kMostVoxel, kMostVoxel));
        };
        m_coordinates.at(i)->setRange(within(first.at(i)), within(last.at(i)));
        constexpr int kDigits = 7; // larger numbers scroll
        m_coordinates.at(i)->setMaximumWidth(fontMetrics().horizontalAdvance(QLatin1Char('0')) *
                                             (kDigits + 5));
    }
}

void VolumePage::showCross() {
    const Vector3d& cross = m_cursor.cross();
    for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
        const QSignalBlocker quiet(m_coordinates.at(i));
        m_coordinates.at(i)->setValue(static_cast<int>(cross[static_cast<Eigen::Index>(i)]));
    }
    showPlace(cross, slice(Axis::Z)->valuesAt(cross));
}

void VolumePage::showPlace(const Vector3d& space, const QString& values) {
    QString text =
        QStringLiteral("x %1 · y %2 · z %3").arg(number(space.x()), number(space.y()), number(space.z()));
    if (!values.isEmpty())
        text += QStringLiteral(" · ") + values;
    m_readout->setFullText(m_shown.source ? text : QString());
}

QString VolumePage::readout() const {
    return m_readout->fullText();
}

void VolumePage::enlarge(QWidget* view) {
    const std::array<QWidget*, 4> all = {slice(Axis::Z), slice(Axis::X), slice(Axis::Y), m_solid};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool shown = view == nullptr || all.at(i) == view;
        all.at(i)->setVisible(shown);
        const int row = static_cast<int>(i / 2), column = static_cast<int>(i % 2);
        if (view == nullptr) {
            m_grid->setRowStretch(row, 1);
            m_grid->setColumnStretch(column, 1);
        }
    }
    for (std::size_t i = 0; view != nullptr && i < all.size(); ++i)
        if (all.at(i) == view)
            for (int line = 0; line < 2; ++line) {
                m_grid->setRowStretch(line, line == static_cast<int>(i / 2) ? 1 : 0);
                m_grid->setColumnStretch(line, line == static_cast<int>(i % 2) ? 1 : 0);
            }
    m_all->setEnabled(view != nullptr);
}

void VolumePage::openFile(const QString& path) {
    m_opening.start(
        {}, [path](JobContext&) { return volumeIn(path); },
        [this](const NamedVolume& volume) {
            if (m_ofFile && !m_choice.empty())
                m_choice.pop_back();
            m_ofFile = volume;
            m_choice.push_back(volume);
            fillChoice(static_cast<int>(m_choice.size()) - 1);
            choose(m_choiceBox->currentIndex());
            Q_EMIT changed();
            Q_EMIT opened();
        },
        [this](const QString& why) {
            fail(why);
            Q_EMIT refused(why);
        });
}

void VolumePage::fail(const QString& sentence) {
    m_message->say(MessageBar::Kind::Error, sentence);
}

QString VolumePage::message() const {
    return m_message->text();
}

SliceView* VolumePage::front() const {
    return m_last && m_last->isVisible() ? m_last.data() : slice(Axis::Z);
}

} // namespace texloom::ui
