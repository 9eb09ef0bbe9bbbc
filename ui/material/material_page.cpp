#include "ui/material/material_page.h"

#include "core/color/color_pipeline.h"
#include "core/session/run/exemplar_file.h"
#include "core/volume/mesh_file.h"
#include "ui/common/message_bar.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/exemplar/resource_folder.h"
#include "ui/jobs/task_bar.h"
#include "ui/material/material_files.h"
#include "ui/material/material_view.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <array>
#include <numbers>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kMostRepeats = 8;
constexpr int kMostStops = 6;
constexpr double kMostRelief = 30; ///< % of the maps' side
constexpr double kHalfTurn = 180;
constexpr int kFields = 4; ///< in a row: small windows have no room for all
constexpr int kTurnPictures = 60, kTurnSide = 1024;
const QString kFromFile = QStringLiteral("file"), kStudio = QStringLiteral("studio-lights");

QString keyFor(const char* name) {
    return QStringLiteral("material/") + QLatin1String(name);
}

float radians(double degrees) {
    return static_cast<float>(degrees * std::numbers::pi / kHalfTurn);
}

std::shared_ptr<const Environment> lightFrom(const QString& path, JobContext& context) {
    if (path == kStudio)
        return std::make_shared<const Environment>(studioPanorama(), context);
    Image panorama(*loadExemplar(toPath(path)).image);
    color::fromWorking(panorama, "linear");
    return std::make_shared<const Environment>(panorama, context);
}

/// Chooses an entry by its data without a signal; nothing if there is none of it.
void choose(QComboBox* box, const QVariant& data) {
    const QSignalBlocker quiet(box);
    if (const int index = box->findData(data); index >= 0)
        box->setCurrentIndex(index);
}

} // namespace

MaterialPage::MaterialPage(QWidget* parent)
    : QWidget(parent), m_shape(new QComboBox(this)), m_light(new QComboBox(this)),
      m_shown(new QComboBox(this)), m_backdrop(new QComboBox(this)), m_repeat(new QSpinBox(this)),
      m_relief(new QDoubleSpinBox(this)), m_exposure(new QDoubleSpinBox(this)),
      m_lightTurn(new QDoubleSpinBox(this)), m_message(new MessageBar(this)), m_view(new MaterialView(this)),
      m_bar(new TaskBar(this)) {
    setObjectName(QStringLiteral("materialPage"));
    m_view->setObjectName(QStringLiteral("materialView"));
    m_view->setToolTip(
        tr("Drag to turn it, with the middle button to move it, with Shift and the right button to turn the "
           "light; the wheel comes nearer. C shows the maps alone, M the material, F frames it, R resets."));
    m_message->dismiss();
    makeFields();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(layOutFields());
    rows->addWidget(m_message);
    rows->addWidget(m_view, 1);
    rows->addWidget(m_bar);
    setFocusProxy(m_view);
    FilesInUse::all().add(this, [this](OutputGuard& guard) {
        if (!m_meshFile.isEmpty())
            guard.reads(toPath(m_meshFile), TR("the mesh that the material is shown on"));
        if (!m_lightFile.isEmpty())
            guard.reads(toPath(m_lightFile), TR("the panorama that lights the material"));
    });
    restore();
    connectFields();
}

MaterialPage::~MaterialPage() = default;

void MaterialPage::makeFields() {
    m_shape->setObjectName(QStringLiteral("materialShape"));
    m_shape->addItem(tr("Plane"), static_cast<int>(BasicShape::Plane));
    m_shape->addItem(tr("Sphere"), static_cast<int>(BasicShape::Sphere));
    m_shape->addItem(tr("Cube"), static_cast<int>(BasicShape::Cube));
    m_shape->addItem(tr("Cylinder"), static_cast<int>(BasicShape::Cylinder));
    m_shape->addItem(tr("Mesh from a file…"), kFromFile);
    m_light->setObjectName(QStringLiteral("materialLight"));
    m_light->addItem(tr("Studio lights"), kStudio);
    for (const auto& [file, title] : {std::pair(QStringLiteral("courtyard.exr"), tr("Courtyard")),
                                      std::pair(QStringLiteral("studio.exr"), tr("Studio room")),
                                      std::pair(QStringLiteral("sunset.exr"), tr("Sunset"))})
        if (const QString folder = resourceFolder(QStringLiteral("environments")); !folder.isEmpty())
            m_light->addItem(title, QStringLiteral("%1/%2").arg(folder, file));
    m_light->addItem(tr("Panorama from a file…"), kFromFile);
    m_shown->setObjectName(QStringLiteral("materialShown"));
    int number = 0;
    for (const QString& title : {tr("Material"), tr("Colour"), tr("Normal"), tr("Roughness"), tr("Metallic"),
                                 tr("Occlusion"), tr("Height"), tr("Opacity")})
        m_shown->addItem(title, number++);
    m_backdrop->setObjectName(QStringLiteral("materialBackdrop"));
    m_backdrop->addItem(tr("Grey"), static_cast<int>(Backdrop::Grey));
    m_backdrop->addItem(tr("Light"), static_cast<int>(Backdrop::Environment));
    m_backdrop->addItem(tr("None"), static_cast<int>(Backdrop::Nothing));
    m_repeat->setObjectName(QStringLiteral("materialRepeat"));
    m_repeat->setRange(1, kMostRepeats);
    m_repeat->setSuffix(QStringLiteral(" ×"));
    m_relief->setObjectName(QStringLiteral("materialRelief"));
    m_relief->setRange(0, kMostRelief);
    m_relief->setSuffix(QStringLiteral(" %"));
    m_relief->setToolTip(
        tr("From the lowest height to the highest, as a share of the maps' side; needs a height map"));
    m_exposure->setObjectName(QStringLiteral("materialExposure"));
    m_exposure->setRange(-kMostStops, kMostStops);
    m_exposure->setSingleStep(0.25);
    m_exposure->setSuffix(tr(" stops"));
    m_lightTurn->setObjectName(QStringLiteral("materialLightTurn"));
    m_lightTurn->setRange(-kHalfTurn, kHalfTurn);
    m_lightTurn->setDecimals(0);
    m_lightTurn->setSingleStep(5);
    m_lightTurn->setWrapping(true);
    m_lightTurn->setSuffix(QStringLiteral("°"));
}

QGridLayout* MaterialPage::layOutFields() {
    constexpr int kShownLetters = 5; // small windows have no room for the longest entry
    for (QComboBox* box : {m_shape, m_light, m_shown, m_backdrop}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kShownLetters);
    }
    auto* grid = new QGridLayout;
    int count = 0;
    const auto add = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        grid->addWidget(label, 2 * (count / kFields), count % kFields);
        grid->addWidget(field, 2 * (count / kFields) + 1, count % kFields);
        ++count;
    };
    add(tr("Shape"), m_shape);
    add(tr("Repeat"), m_repeat);
    add(tr("Relief"), m_relief);
    add(tr("Show"), m_shown);
    add(tr("Lit by"), m_light);
    add(tr("Turned by"), m_lightTurn);
    add(tr("Exposure"), m_exposure);
    add(tr("Background"), m_backdrop);
    const auto addButton = [&](const QString& text, const char* name, int row, auto act) {
        auto* button = new QPushButton(text, this);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        grid->addWidget(button, row, kFields);
    };
    addButton(tr("Save picture…"), "materialSave", 1, &MaterialPage::askForPicture);
    addButton(tr("Turntable…"), "materialTurntable", 3, &MaterialPage::askForTurntable);
    for (int column = 0; column < kFields; ++column)
        grid->setColumnStretch(column, 1);
    return grid;
}

void MaterialPage::connectFields() {
    connect(m_shape, &QComboBox::activated, this, &MaterialPage::shapeChosen);
    connect(m_light, &QComboBox::activated, this, &MaterialPage::lightChosen);
    for (QComboBox* box : {m_shown, m_backdrop})
        connect(box, &QComboBox::currentIndexChanged, this, &MaterialPage::lookEdited);
    connect(m_repeat, &QSpinBox::valueChanged, this, &MaterialPage::lookEdited);
    for (QDoubleSpinBox* box : {m_relief, m_exposure, m_lightTurn})
        connect(box, &QDoubleSpinBox::valueChanged, this, &MaterialPage::lookEdited);
    connect(m_view, &MaterialView::lookChanged, this, &MaterialPage::showFields);
    connect(m_view, &MaterialView::failed, this, &MaterialPage::fail);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_saving.cancel();
        m_bar->end();
    });
}

void MaterialPage::restore() {
    const QSettings settings;
    choose(m_shape, settings.value(keyFor("shape"), static_cast<int>(BasicShape::Sphere)).toInt());
    choose(m_light, settings.value(keyFor("light"), kStudio));
    Look look;
    look.repeat = settings.value(keyFor("repeat"), 1).toFloat();
    look.relief = settings.value(keyFor("relief"), 0).toFloat();
    look.exposure = settings.value(keyFor("exposure"), 0).toFloat();
    look.backdrop =
        static_cast<Backdrop>(settings.value(keyFor("backdrop"), static_cast<int>(Backdrop::Grey)).toInt());
    m_view->setLook(look);
    showFields();
}

void MaterialPage::keep() const {
    QSettings settings;
    if (m_shape->currentData() != kFromFile)
        settings.setValue(keyFor("shape"), m_shape->currentData());
    if (m_light->currentData() != kFromFile)
        settings.setValue(keyFor("light"), m_light->currentData());
    const Look& look = m_view->look();
    settings.setValue(keyFor("repeat"), look.repeat);
    settings.setValue(keyFor("relief"), look.relief);
    settings.setValue(keyFor("exposure"), look.exposure);
    settings.setValue(keyFor("backdrop"), static_cast<int>(look.backdrop));
}

/// The fields as the look has them.
void MaterialPage::showFields() {
    const Look& look = m_view->look();
    choose(m_shown, static_cast<int>(look.shown));
    choose(m_backdrop, static_cast<int>(look.backdrop));
    const QSignalBlocker quiet[] = {QSignalBlocker(m_repeat), QSignalBlocker(m_relief),
                                    QSignalBlocker(m_exposure), QSignalBlocker(m_lightTurn)};
    m_repeat->setValue(static_cast<int>(look.repeat));
    m_relief->setValue(100 * static_cast<double>(look.relief));
    m_exposure->setValue(static_cast<double>(look.exposure));
    m_lightTurn->setValue(static_cast<double>(look.lightTurn) * kHalfTurn / std::numbers::pi);
}

void MaterialPage::lookEdited() {
    Look look = m_view->look();
    look.shown = static_cast<Shown>(m_shown->currentData().toInt());
    look.backdrop = static_cast<Backdrop>(m_backdrop->currentData().toInt());
    look.repeat = static_cast<float>(m_repeat->value());
    look.relief = static_cast<float>(m_relief->value() / 100);
    look.exposure = static_cast<float>(m_exposure->value());
    look.lightTurn = radians(m_lightTurn->value());
    m_view->setLook(look);
    keep();
}

void MaterialPage::showPictures(const RunPictures& pictures) {
    if (pictures.run)
        m_source = [run = pictures.run] { return materialOf(*run); };
    else if (pictures.result)
        m_source = [picture = pictures.result] { return materialOf(picture->values()); };
    else
        m_source = [] { return Material(); };
    if (isVisible())
        takeMaterial();
}

void MaterialPage::showEvent(QShowEvent*) {
    if (!m_view->mesh() && !m_meshing.running())
        shapeChosen();
    if (!m_view->light() && !m_lighting.running())
        lightChosen();
    takeMaterial();
}

/// Prepares what is to be shown, off the GUI thread; the one that is shown stays until then.
void MaterialPage::takeMaterial() {
    if (!m_source)
        return;
    m_taking.start(
        {},
        [source = std::exchange(m_source, {})](JobContext&) -> std::shared_ptr<const MaterialTexture> {
            const Material material = source();
            return material.maps.empty() ? nullptr : std::make_shared<const MaterialTexture>(material);
        },
        [this](std::shared_ptr<const MaterialTexture> material) {
            m_message->dismiss();
            m_view->setMaterial(std::move(material));
        },
        [this](const QString& why) { fail(why); });
}

void MaterialPage::shapeChosen() {
    const QVariant chosen = m_shape->currentData();
    if (chosen == kFromFile) {
        const QString path = QFileDialog::getOpenFileName(this, tr("Mesh to show the material on"), {},
                                                          tr("Meshes (*.obj *.ply *.gltf *.glb)"));
        if (!path.isEmpty())
            openMesh(path);
        return;
    }
    m_meshing.start(
        {},
        [shape = static_cast<BasicShape>(chosen.toInt())](JobContext&) {
            return std::make_shared<const RenderMesh>(renderMesh(shape));
        },
        [this](std::shared_ptr<const RenderMesh> mesh) {
            m_meshFile.clear();
            m_view->setMesh(std::move(mesh));
        },
        [this](const QString& why) { fail(why); });
    keep();
}

void MaterialPage::openMesh(const QString& path) {
    choose(m_shape, kFromFile);
    m_meshing.start(
        {},
        [path](JobContext& context) {
            return std::make_shared<const RenderMesh>(renderMesh(readMesh(toPath(path), context)));
        },
        [this, path](std::shared_ptr<const RenderMesh> mesh) {
            m_meshFile = path;
            m_message->dismiss();
            m_view->setMesh(std::move(mesh));
        },
        [this](const QString& why) { fail(why); });
}

void MaterialPage::lightChosen() {
    const QString chosen = m_light->currentData().toString();
    if (chosen == kFromFile) {
        const QString path = QFileDialog::getOpenFileName(this, tr("Panorama to light the material by"), {},
                                                          tr("Pictures (*.exr *.hdr *.tif *.png *.jpg)"));
        if (!path.isEmpty())
            openPanorama(path);
        return;
    }
    openPanorama(chosen);
    keep();
}

void MaterialPage::openPanorama(const QString& path) {
    choose(m_light, m_light->findData(path) >= 0 ? path : kFromFile);
    m_lighting.start(
        {}, [path](JobContext& context) { return lightFrom(path, context); },
        [this, path](std::shared_ptr<const Environment> light) {
            m_lightFile = path == kStudio ? QString() : path;
            m_message->dismiss();
            m_view->setLight(std::move(light));
        },
        [this](const QString& why) { fail(why); });
}

void MaterialPage::fail(const QString& sentence) {
    m_message->say(MessageBar::Kind::Error, sentence);
}

QString MaterialPage::message() const {
    return m_message->text();
}

void MaterialPage::askForPicture() {
    const QString path =
        askWhereToSave(this, tr("Save the picture of the material"), QStringLiteral("material.png"),
                       tr("Pictures (*.png *.exr *.tif *.jpg)"), {QStringLiteral("png")});
    if (!path.isEmpty())
        savePicture(path);
}

void MaterialPage::askForTurntable() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the pictures of a turn"));
    if (!folder.isEmpty())
        saveTurntable(folder, kTurnPictures, kTurnSide);
}

void MaterialPage::savePicture(const QString& path) {
    if (!m_view->material())
        return fail(tr("There is no material to save a picture of yet; press Run first."));
    const QSize shown = m_view->size() * m_view->devicePixelRatioF();
    const Scene scene{
        m_view->mesh(), m_view->material(), m_view->light(), m_view->look(), {shown.width(), shown.height()}};
    m_saving.start(
        {},
        [scene, path, guard = SaveGuard()](JobContext& context) {
            guard.check(toPath(path), TR("picture of the material"));
            return writePicture(scene, toPath(path), context);
        },
        [this, path](int) { Q_EMIT saved(QFileInfo(path).path()); },
        [this](const QString& why) { fail(why); });
}

void MaterialPage::saveTurntable(const QString& folder, int pictures, int side) {
    if (!m_view->material())
        return fail(tr("There is no material to save a picture of yet; press Run first."));
    const Scene scene{m_view->mesh(), m_view->material(), m_view->light(), m_view->look(), {side, side}};
    m_saving.start(
        {},
        [scene, folder, pictures, guard = SaveGuard()](JobContext& context) {
            guard.check({}, TR("picture of the turn"), turnFiles(toPath(folder), pictures));
            return writeTurn(scene, toPath(folder), pictures, context);
        },
        [this, folder](int) {
            m_bar->end();
            Q_EMIT saved(folder);
        },
        [this](const QString& why) {
            m_bar->end();
            fail(why);
        });
    m_bar->begin(tr("Writing %1 pictures of a turn").arg(pictures), [this] { return m_saving.progress(); });
}

} // namespace texloom::ui
