#include "ui/volume/slice_panel.h"

#include "ui/common/message_bar.h"
#include "ui/viewers/image_viewer.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace texloom::ui {

namespace {

using Eigen::Vector3d;

constexpr int kFarthest = 1'000'000'000; ///< of coordinates that can be typed in
constexpr int kSmallestSide = 16, kLargestSide = 2048, kFirstSide = 256;
constexpr int kPageStep = 10;
constexpr int kColumns = 4;    ///< of fields: small windows have no room for all in one row
constexpr double kPart = 0.25; ///< of the picture that one step along the slice moves it by
constexpr double kHalfTurn = 180;
constexpr int kPatience = 200; ///< ms after which it is said that a slice is being made

double radians(double degrees) {
    return degrees * std::numbers::pi / kHalfTurn;
}

} // namespace

SlicePanel::SlicePanel(QWidget* parent)
    : QWidget(parent),
      m_axis(new QComboBox(this)), m_middle{new QSpinBox(this), new QSpinBox(this), new QSpinBox(this)},
      m_turn(new QDoubleSpinBox(this)), m_tilt(new QDoubleSpinBox(this)), m_side(new QSpinBox(this)),
      m_message(new MessageBar(this)), m_viewer(new ImageViewer(this)) {
    setObjectName(QStringLiteral("slicePanel"));
    m_viewer->setObjectName(QStringLiteral("sliceViewer"));
    m_viewer->setPlaceholder(tr("There is no volume to look at."));
    makeFields();
    layOut();
    addKeys();
    setFocusProxy(m_viewer);
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connect(&m_patience, &QTimer::timeout, this, [this] { m_viewer->setBadge(tr("Making the slice…")); });
}

SlicePanel::~SlicePanel() = default;

void SlicePanel::makeFields() {
    m_axis->setObjectName(QStringLiteral("sliceAxis"));
    m_axis->setToolTip(tr("The axis that the slice is square to while it is not turned"));
    for (const auto& [axis, title] :
         {std::pair(Axis::Z, tr("Square to z")), std::pair(Axis::Y, tr("Square to y")),
          std::pair(Axis::X, tr("Square to x"))})
        m_axis->addItem(title, static_cast<int>(axis));
    connect(m_axis, &QComboBox::currentIndexChanged, this, &SlicePanel::makeSlice);
    const std::array<QString, 3> names = {QStringLiteral("sliceX"), QStringLiteral("sliceY"),
                                          QStringLiteral("sliceZ")};
    for (std::size_t i = 0; i < m_middle.size(); ++i) {
        m_middle.at(i)->setObjectName(names.at(i));
        m_middle.at(i)->setToolTip(tr("The voxel in the middle of the picture"));
        m_middle.at(i)->setRange(-kFarthest, kFarthest);
        connect(m_middle.at(i), &QSpinBox::valueChanged, this, &SlicePanel::makeSlice);
    }
    for (QDoubleSpinBox* angle : {m_turn, m_tilt}) {
        angle->setRange(-kHalfTurn, kHalfTurn);
        angle->setDecimals(1);
        angle->setSingleStep(5);
        angle->setWrapping(true);
        angle->setSuffix(QStringLiteral("°"));
        connect(angle, &QDoubleSpinBox::valueChanged, this, &SlicePanel::makeSlice);
    }
    m_turn->setObjectName(QStringLiteral("sliceTurn"));
    m_turn->setToolTip(tr("How far the slice is turned about the picture's vertical"));
    m_tilt->setObjectName(QStringLiteral("sliceTilt"));
    m_tilt->setToolTip(tr("How far the slice is turned about the picture's horizontal"));
    m_side->setObjectName(QStringLiteral("sliceSide"));
    m_side->setToolTip(tr("Width and height of the picture"));
    m_side->setRange(kSmallestSide, kLargestSide);
    m_side->setValue(kFirstSide);
    m_side->setSuffix(tr(" px"));
    connect(m_side, &QSpinBox::valueChanged, this, &SlicePanel::makeSlice);
    m_message->dismiss();
}

void SlicePanel::layOut() {
    auto* grid = new QGridLayout;
    int count = 0;
    const auto add = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        const int row = 2 * (count / kColumns), column = count % kColumns;
        grid->addWidget(label, row, column);
        grid->addWidget(field, row + 1, column);
        ++count;
    };
    add(tr("Slice"), m_axis);
    add(tr("Middle x"), m_middle[0]);
    add(tr("Middle y"), m_middle[1]);
    add(tr("Middle z"), m_middle[2]);
    add(tr("Turn"), m_turn);
    add(tr("Tilt"), m_tilt);
    add(tr("Side"), m_side);
    grid->setColumnStretch(kColumns, 1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(grid);
    rows->addWidget(m_message);
    rows->addWidget(m_viewer, 1);
}

void SlicePanel::addKeys() {
    const auto add = [this](const QKeySequence& keys, auto act) {
        auto* shortcut = new QShortcut(keys, this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, act);
    };
    add(Qt::Key_PageUp, [this] { step(-1); });
    add(Qt::Key_PageDown, [this] { step(1); });
    add(Qt::CTRL | Qt::Key_PageUp, [this] { step(-kPageStep); });
    add(Qt::CTRL | Qt::Key_PageDown, [this] { step(kPageStep); });
    add(Qt::CTRL | Qt::Key_Left, [this] { moveAlong(-kPart, 0); });
    add(Qt::CTRL | Qt::Key_Right, [this] { moveAlong(kPart, 0); });
    add(Qt::CTRL | Qt::Key_Up, [this] { moveAlong(0, -kPart); });
    add(Qt::CTRL | Qt::Key_Down, [this] { moveAlong(0, kPart); });
}

void SlicePanel::setSource(std::shared_ptr<const VolumeSource> source) {
    m_source = std::move(source);
    if (m_source)
        fitFields(*m_source);
    makeSlice();
}

/// The middle of what there is and all of it, or the origin.
void SlicePanel::fitFields(const VolumeSource& source) {
    std::array<std::int64_t, 3> begin{-kFarthest, -kFarthest, -kFarthest};
    std::array<int, 3> length{2 * kFarthest + 1, 2 * kFarthest + 1, 2 * kFarthest + 1};
    VolumeSize whole = source.period();
    if (const std::optional<Box> bounds = source.bounds()) {
        begin = {bounds->x, bounds->y, bounds->z};
        length = {bounds->size.width, bounds->size.height, bounds->size.depth};
        whole = bounds->size;
    }
    for (std::size_t i = 0; i < m_middle.size(); ++i) {
        const QSignalBlocker quiet(m_middle.at(i));
        const auto first = static_cast<int>(std::clamp<std::int64_t>(begin.at(i), -kFarthest, kFarthest));
        const auto last =
            static_cast<int>(std::clamp<std::int64_t>(begin.at(i) + length.at(i) - 1, -kFarthest, kFarthest));
        m_middle.at(i)->setRange(first, last);
        m_middle.at(i)->setValue(first + static_cast<int>((std::int64_t{last} - first) / 2));
    }
    if (!whole.empty()) {
        const QSignalBlocker quiet(m_side);
        m_side->setValue(std::max({whole.width, whole.height, whole.depth}));
    }
}

Plane SlicePanel::plane() const {
    const Vector3d middle(m_middle[0]->value(), m_middle[1]->value(), m_middle[2]->value());
    Plane plane = axisPlane(static_cast<Axis>(m_axis->currentData().toInt()), middle);
    const int half = m_side->value() / 2;
    plane.origin = plane.at(-half, -half);
    return turned(plane, middle, radians(m_turn->value()), radians(m_tilt->value()));
}

Size SlicePanel::pictureSize() const {
    return {m_side->value(), m_side->value()};
}

void SlicePanel::setAxis(Axis axis) {
    m_axis->setCurrentIndex(m_axis->findData(static_cast<int>(axis)));
}

void SlicePanel::setMiddle(int x, int y, int z) {
    moveBy(Vector3d(x, y, z) - Vector3d(m_middle[0]->value(), m_middle[1]->value(), m_middle[2]->value()));
}

std::array<int, 3> SlicePanel::middle() const {
    return {m_middle[0]->value(), m_middle[1]->value(), m_middle[2]->value()};
}

void SlicePanel::setAngles(double turn, double tilt) {
    m_turn->setValue(turn);
    m_tilt->setValue(tilt);
}

void SlicePanel::step(int voxels) {
    const Plane here = plane();
    const Vector3d across = here.right.cross(here.down).cwiseAbs();
    // Of a slice that is turned the axis that it is most nearly square to.
    Eigen::Index axis = 0;
    across.maxCoeff(&axis);
    moveBy(voxels * Vector3d::Unit(axis));
}

void SlicePanel::moveAlong(double right, double down) {
    const Plane here = plane();
    moveBy(m_side->value() * (right * here.right + down * here.down));
}

/// One slice is made for all three coordinates.
void SlicePanel::moveBy(const Vector3d& distance) {
    for (std::size_t i = 0; i < m_middle.size(); ++i) {
        const QSignalBlocker quiet(m_middle.at(i));
        const double to = m_middle.at(i)->value() + distance[static_cast<Eigen::Index>(i)];
        m_middle.at(i)->setValue(
            static_cast<int>(std::lround(std::clamp<double>(to, -kFarthest, kFarthest))));
    }
    makeSlice();
}

QString SlicePanel::message() const {
    return m_message->text();
}

void SlicePanel::makeSlice() {
    m_task.cancel();
    m_viewer->setBadge({});
    m_patience.stop();
    if (!m_source) {
        m_message->dismiss();
        m_viewer->setPicture(nullptr);
        return;
    }
    m_patience.start();
    const auto ended = [this](std::shared_ptr<const DisplayPicture> picture) {
        m_patience.stop();
        m_viewer->setBadge({});
        m_viewer->setPicture(std::move(picture));
    };
    m_task.start(
        {},
        [source = m_source, plane = plane(), size = pictureSize()](JobContext& context) {
            return std::make_shared<const DisplayPicture>(
                std::make_shared<const Image>(slice(*source, plane, size, context)));
        },
        [this, ended](std::shared_ptr<const DisplayPicture> picture) {
            ended(std::move(picture));
            m_message->dismiss();
            Q_EMIT shown();
        },
        [this, ended](const QString& sentence) {
            ended(nullptr);
            m_message->say(MessageBar::Kind::Error, sentence);
            Q_EMIT shown();
        });
}

} // namespace texloom::ui
