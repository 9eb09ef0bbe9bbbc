#include "ui/volume/solid_panel.h"

#include "core/volume/mesh_file.h"
#include "ui/common/text.h"
#include "ui/volume/slice_view.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace texloom::ui {

namespace {

using Eigen::Vector3d;

constexpr double kHalfCircle = 180;
constexpr int kFirstBlock = 96, kLargestBlock = 256, kSmallestBlock = 8;
constexpr int kFirstScale = 128, kSmallestScale = 8, kLargestScale = 1024;
constexpr int kFileShape = -1;

QDoubleSpinBox* angleBox(const QString& name, const QString& help, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(name);
    box->setRange(-kHalfCircle, kHalfCircle);
    box->setDecimals(0);
    box->setSingleStep(5);
    box->setWrapping(true);
    box->setSuffix(QStringLiteral("°"));
    box->setToolTip(help);
    box->setAccessibleName(help);
    return box;
}

/// A row of labels with their fields.
QWidget* rowOf(const std::vector<std::pair<QString, QWidget*>>& fields) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const auto& [text, field] : fields) {
        if (!text.isEmpty()) {
            auto* label = new QLabel(text, row);
            label->setBuddy(field);
            layout->addWidget(label);
        }
        layout->addWidget(field);
    }
    layout->addStretch();
    return row;
}

double longestSide(const Mesh& mesh) {
    const Mesh::Bounds bounds = mesh.bounds();
    return std::max(static_cast<double>((bounds.highest - bounds.lowest).maxCoeff()), 1e-20);
}

} // namespace

SolidPanel::SolidPanel(VolumeCursor* cursor, QWidget* parent)
    : QWidget(parent), m_cursor(cursor), m_views(new QComboBox(this)), m_fields(new QStackedWidget(this)),
      m_stack(new QStackedWidget(this)), m_oblique(new SliceView(std::nullopt, cursor, this)),
      m_block(new SolidView(this)), m_mesh(new SolidView(this)) {
    setObjectName(QStringLiteral("solidPanel"));
    m_oblique->setObjectName(QStringLiteral("sliceOblique"));
    m_block->setObjectName(QStringLiteral("solidBlock"));
    m_block->setAccessibleName(tr("Block with a part cut away"));
    m_block->setToolTip(tr("Drag to turn it, with Ctrl to move the cut, which goes through the crosshair; "
                           "the wheel comes nearer. Double click gives it all the room."));
    m_mesh->setObjectName(QStringLiteral("solidMesh"));
    m_mesh->setAccessibleName(tr("Mesh with the volume's colours"));
    m_mesh->setToolTip(tr("Drag to turn it, with Ctrl to move the volume in the mesh; the wheel comes "
                          "nearer. Double click gives it all the room."));
    m_views->setObjectName(QStringLiteral("solidViews"));
    m_views->addItems({tr("Oblique slice"), tr("Block"), tr("Mesh")});
    m_views->setToolTip(tr("What the fourth view shows"));
    m_views->setAccessibleName(tr("What the fourth view shows"));
    m_fields->addWidget(makeObliqueFields());
    m_fields->addWidget(makeBlockFields());
    m_fields->addWidget(makeMeshFields());
    m_fields->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // they never widen the window
    for (QWidget* view :
         {static_cast<QWidget*>(m_oblique), static_cast<QWidget*>(m_block), static_cast<QWidget*>(m_mesh)})
        m_stack->addWidget(view);
    auto* top = new QVBoxLayout;
    top->addWidget(m_views);
    top->addWidget(m_fields);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(top);
    column->addWidget(m_stack, 1);
    connect(m_views, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_stack->setCurrentIndex(index);
        m_fields->setCurrentIndex(index);
        showBlock();
        showMesh();
    });
    connect(cursor, &VolumeCursor::crossMoved, this, &SolidPanel::showBlock);
    connect(cursor, &VolumeCursor::turned, this, [this] {
        const QSignalBlocker one(m_turn), other(m_tilt);
        m_turn->setValue(m_cursor->turn());
        m_tilt->setValue(m_cursor->tilt());
    });
    for (SolidView* view : {m_block, m_mesh}) {
        connect(view, &SolidView::failed, this, &SolidPanel::failed);
        connect(view, &SolidView::enlargeWanted, this, &SolidPanel::enlargeWanted);
    }
    connect(m_oblique, &SliceView::enlargeWanted, this, &SolidPanel::enlargeWanted);
    connect(m_block, &SolidView::moveWanted, this, &SolidPanel::moveCut);
    connect(m_mesh, &SolidView::moveWanted, this, &SolidPanel::moveTexture);
    m_views->setCurrentIndex(Block);
}

SolidPanel::~SolidPanel() = default;

QWidget* SolidPanel::makeObliqueFields() {
    m_turn = angleBox(QStringLiteral("sliceTurn"),
                      tr("How far the slice is turned about the picture's vertical"), this);
    m_tilt = angleBox(QStringLiteral("sliceTilt"),
                      tr("How far the slice is turned about the picture's horizontal"), this);
    m_turn->setValue(m_cursor->turn());
    auto* diagonal = new QPushButton(QStringLiteral("45°"), this);
    diagonal->setToolTip(tr("Cuts at 45° between x and z"));
    connect(diagonal, &QPushButton::clicked, this, [this] { m_cursor->setAngles(45, 0); });
    for (const QDoubleSpinBox* box : {m_turn, m_tilt})
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this] { m_cursor->setAngles(m_turn->value(), m_tilt->value()); });
    return rowOf({{tr("Turn"), m_turn}, {tr("Tilt"), m_tilt}, {{}, diagonal}});
}

QWidget* SolidPanel::makeBlockFields() {
    m_cut = new QComboBox(this);
    m_cut->setObjectName(QStringLiteral("blockCut"));
    m_cut->addItems({tr("Nothing"), tr("Corner"), tr("Beyond x"), tr("Above y"), tr("Before z")});
    m_cut->setCurrentIndex(static_cast<int>(CutAway::Corner));
    m_cut->setToolTip(tr("What is cut away at the crosshair"));
    m_side = new QSpinBox(this);
    m_side->setObjectName(QStringLiteral("blockSide"));
    m_side->setRange(kSmallestBlock, kLargestBlock);
    m_side->setSingleStep(kSmallestBlock);
    m_side->setValue(kFirstBlock);
    m_side->setKeyboardTracking(false);
    m_side->setToolTip(tr("Voxels along the block's sides"));
    connect(m_cut, &QComboBox::currentIndexChanged, this, &SolidPanel::showBlock);
    connect(m_side, &QSpinBox::valueChanged, this, [this] {
        m_box = {};
        showBlock();
    });
    return rowOf({{tr("Cut"), m_cut}, {tr("Side"), m_side}});
}

QWidget* SolidPanel::makeMeshFields() {
    m_shape = new QComboBox(this);
    m_shape->setObjectName(QStringLiteral("solidShape"));
    m_shape->addItem(tr("Plane"), static_cast<int>(BasicShape::Plane));
    m_shape->addItem(tr("Sphere"), static_cast<int>(BasicShape::Sphere));
    m_shape->addItem(tr("Cube"), static_cast<int>(BasicShape::Cube));
    m_shape->addItem(tr("Cylinder"), static_cast<int>(BasicShape::Cylinder));
    m_shape->addItem(tr("From a file…"), kFileShape);
    m_shape->setCurrentIndex(m_lastShape);
    m_shape->setToolTip(tr("The surface; it needs no places in a texture"));
    m_shape->setAccessibleName(tr("Surface"));
    m_scale = new QSpinBox(this);
    m_scale->setObjectName(QStringLiteral("solidScale"));
    m_scale->setRange(kSmallestScale, kLargestScale);
    m_scale->setValue(kFirstScale);
    m_scale->setKeyboardTracking(false);
    m_scale->setToolTip(tr("Voxels along the mesh's longest side: more of them are smaller"));
    std::vector<std::pair<QString, QWidget*>> fields{{{}, m_shape}, {tr("Scale"), m_scale}};
    const std::array<QString, 3> help = {tr("How far the volume is turned about x"),
                                         tr("How far the volume is turned about y"),
                                         tr("How far the volume is turned about z")};
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
        const QString axis(QStringLiteral("xyz").at(static_cast<int>(i)));
        m_angles.at(i) = angleBox(QStringLiteral("solidAngle_") + axis, help.at(i), this);
        connect(m_angles.at(i), &QDoubleSpinBox::valueChanged, this, &SolidPanel::showMesh);
        fields.emplace_back(axis, m_angles.at(i));
    }
    connect(m_shape, &QComboBox::activated, this, &SolidPanel::shapeChosen);
    connect(m_scale, &QSpinBox::valueChanged, this, &SolidPanel::showMesh);
    return rowOf(fields);
}

void SolidPanel::setSource(const std::shared_ptr<const VolumeSource>& source) {
    m_oblique->setSource(source);
    const auto cache = source ? std::make_shared<const BlockCache>(source) : nullptr;
    m_box = source && source->bounds() ? *source->bounds() : Box{};
    const VolumeSize& size = m_box.size;
    if (std::max({size.width, size.height, size.depth}) > kLargestBlock)
        m_box = {};
    m_side->setEnabled(m_box.size.empty());
    m_textureAt = m_cursor->cross();
    m_block->setSolid(cache);
    m_mesh->setSolid(cache);
    if (source && !m_lighting.running())
        makeLight();
    showBlock();
    showMesh();
}

void SolidPanel::makeLight() {
    m_lighting.start(
        {},
        [](JobContext& context) { return std::make_shared<const Environment>(studioPanorama(), context); },
        [this](const std::shared_ptr<const Environment>& light) {
            m_block->setLight(light);
            m_mesh->setLight(light);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void SolidPanel::setView(View view) {
    m_views->setCurrentIndex(view);
}

SolidPanel::View SolidPanel::view() const {
    return static_cast<View>(m_views->currentIndex());
}

QWidget* SolidPanel::current() const {
    return m_stack->currentWidget();
}

/// The block stays where it is until the crosshair leaves it.
void SolidPanel::showBlock() {
    if (view() != Block)
        return;
    const Vector3d cross = m_cursor->cross();
    const auto whole = [&](int axis) { return static_cast<std::int64_t>(cross[axis]); };
    if (!Box{whole(0), whole(1), whole(2), {1, 1, 1}}.within(m_box)) {
        const int side = m_side->value();
        m_box = {whole(0) - side / 2, whole(1) - side / 2, whole(2) - side / 2, {side, side, side}};
        if (m_cursor->bounds())
            m_box = intersection(m_box, *m_cursor->bounds());
    }
    const Vector3d from = cross - Vector3d(static_cast<double>(m_box.x), static_cast<double>(m_box.y),
                                           static_cast<double>(m_box.z));
    const Eigen::Vector3f share = from.cast<float>().cwiseQuotient(sidesOf(m_box));
    // In space y points up and z towards the viewer; in the volume they go down and away.
    const Eigen::Vector3f cut(share.x(), 1 - share.y(), 1 - share.z());
    m_block->setMesh(std::make_shared<const RenderMesh>(
                         carvedBlock(sidesOf(m_box), static_cast<CutAway>(m_cut->currentIndex()), cut)),
                     placementIn(m_box));
}

void SolidPanel::moveCut(const Vector3d& voxels) {
    m_cutLeft += voxels;
    const Vector3d whole = m_cutLeft.array().round();
    m_cutLeft -= whole;
    m_cursor->setCross(m_cursor->cross() + whole);
}

void SolidPanel::shapeChosen() {
    if (m_shape->currentData().toInt() == kFileShape) {
        const QString path = QFileDialog::getOpenFileName(this, tr("Mesh to show the volume on"), {},
                                                          tr("Meshes (*.obj *.ply *.gltf *.glb)"));
        m_shape->setCurrentIndex(m_lastShape);
        if (!path.isEmpty())
            openMesh(path);
        return;
    }
    m_lastShape = m_shape->currentIndex();
    m_meshes = {};
    showMesh();
}

void SolidPanel::openMesh(const QString& path) {
    m_meshing.start(
        {},
        [path](JobContext& context) {
            Mesh mesh = readMesh(toPath(path), context);
            auto read = std::make_shared<const Mesh>(mesh);
            return Meshes{std::make_shared<const RenderMesh>(renderMesh(std::move(mesh))), std::move(read),
                          path};
        },
        [this](const Meshes& meshes) {
            m_lastShape = m_shape->findData(kFileShape);
            m_shape->setCurrentIndex(m_lastShape);
            take(meshes);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void SolidPanel::take(const Meshes& meshes) {
    m_meshes = meshes;
    showMesh();
}

/// From coordinates of the mesh that is drawn to voxels.
SolidPlacement SolidPanel::placement() const {
    SolidPlacement placement;
    if (m_meshes.drawn)
        placement.scale = m_scale->value() / longestSide(m_meshes.drawn->mesh);
    for (std::size_t i = 0; i < m_angles.size(); ++i)
        placement.angles[static_cast<Eigen::Index>(i)] =
            m_angles.at(i)->value() * std::numbers::pi / kHalfCircle;
    placement.offset = m_textureAt;
    return placement;
}

void SolidPanel::showMesh() {
    if (view() != OnMesh)
        return;
    if (!m_meshes.drawn && !m_meshing.running()) {
        m_meshing.start(
            {},
            [shape = static_cast<BasicShape>(m_shape->currentData().toInt())](JobContext&) {
                auto drawn = std::make_shared<const RenderMesh>(renderMesh(shape));
                return Meshes{drawn, std::shared_ptr<const Mesh>(drawn, &drawn->mesh)};
            },
            [this](const Meshes& meshes) { take(meshes); },
            [this](const QString& why) { Q_EMIT failed(why); });
        return;
    }
    m_mesh->setMesh(m_meshes.drawn, placement());
}

void SolidPanel::moveTexture(const Vector3d& voxels) {
    m_textureAt -= voxels; // what is dragged stays under the mouse
    showMesh();
}

/// A mesh is drawn moved to the origin and scaled to a radius of 1; its file has it as it was.
PlacedMesh SolidPanel::placed() const {
    SolidPlacement placement = this->placement();
    if (!m_meshes.read || m_meshes.read.get() == &m_meshes.drawn->mesh)
        return {m_meshes.read, placement};
    const Mesh::Bounds bounds = m_meshes.read->bounds();
    placement.scale = m_scale->value() / longestSide(*m_meshes.read);
    const Eigen::Vector3f middle = (bounds.lowest + bounds.highest) / 2;
    placement.offset -= placement.scale * (placement.rotation() * middle.cast<double>());
    return {m_meshes.read, placement};
}

} // namespace texloom::ui
