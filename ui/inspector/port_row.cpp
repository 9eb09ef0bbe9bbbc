#include "ui/inspector/port_row.h"

#include "core/base/text.h"
#include "core/session/export/output_files.h"
#include "ui/common/background.h"
#include "ui/common/elided_label.h"
#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/exemplar/layer_dialog.h"
#include "ui/inspector/picture_tile.h"
#include "ui/inspector/thumbnail.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <utility>

namespace texloom::ui {

namespace {

/// Lines of text that a thumbnail is high.
constexpr int kThumbnailLines = 2;

/// The filter of a dialog that opens what a port takes.
QString filterFor(AssetKind kind) {
    const QString all = PortRow::tr("All files (*)");
    switch (kind) {
    case AssetKind::Model:
        return PortRow::tr("Models (%1)").arg(QStringLiteral("*.safetensors")) + QStringLiteral(";;") + all;
    case AssetKind::Volume:
        return PortRow::tr("Volumes and slices (%1)")
                   .arg(QStringLiteral("*.json *.png *.tif *.tiff *.exr *.jpg *.hdr")) +
               QStringLiteral(";;") + all;
    case AssetKind::Mesh:
        return PortRow::tr("Meshes (%1)").arg(QStringLiteral("*.obj *.ply *.gltf *.glb")) +
               QStringLiteral(";;") + all;
    case AssetKind::Image:
    case AssetKind::Mask:
    case AssetKind::Map:
        break;
    }
    return pictureFilter();
}

/// That a result has nothing of this kind.
QString nothingOf(const Port& port) {
    switch (port.kind) {
    case AssetKind::Map:
        return PortRow::tr("This result has no position map; choose one whose method copies pixels.");
    case AssetKind::Mask:
        return PortRow::tr("This result has no mask; choose one of a method that gives masks.");
    case AssetKind::Model:
        return PortRow::tr("This result has no model of the kind %1; choose one of a method that learns such "
                           "models.")
            .arg(QString::fromStdString(port.id));
    case AssetKind::Volume:
        return PortRow::tr("This result has no volume; choose one of a method that gives volumes.");
    case AssetKind::Mesh:
        return PortRow::tr("This result has no mesh; choose one of a method that gives meshes.");
    case AssetKind::Image:
        break;
    }
    return PortRow::tr("This result has no picture; choose another.");
}

} // namespace

PortRow::PortRow(const Port& port, const PortLook& look, QWidget* parent)
    : DropField(parent), m_port(port), m_name(new ElidedLabel(this)),
      m_useResult(makeButton(QStringLiteral("useResult_"), &PortRow::useShown)),
      m_paint(makeButton(QStringLiteral("paint_"), &PortRow::paint)),
      m_extend(makeButton(QStringLiteral("extend_"), &PortRow::extend)),
      m_clear(makeButton(QStringLiteral("clear_"), &PortRow::clear)) {
    const QString title = translated(m_port.title);
    setObjectName(QStringLiteral("port_") + QString::fromStdString(m_port.id));
    setAcceptDrops(true);
    setToolTip(
        QStringLiteral("<b>%1</b> %2").arg(title.toHtmlEscaped(), translated(m_port.help).toHtmlEscaped()));
    m_useResult->setAccessibleName(tr("Take the result that is shown: %1").arg(title));
    setIconButton(m_paint, QStringLiteral("brush"),
                  m_port.kind == AssetKind::Mask ? tr("Paint the mask: %1…").arg(title)
                                                 : tr("Paint: %1…").arg(title));
    m_paint->setVisible(look.paints);
    setIconButton(m_extend, QStringLiteral("extend"), tr("Extend the picture beyond its edges…"));
    m_extend->setVisible(look.extends);
    setIconButton(m_clear, QStringLiteral("close"), tr("Go without: %1").arg(title));
    if (look.tile)
        layTile(look.letter);
    else
        layRow(look.extends);
    m_choose->setAccessibleName(tr("Choose a file: %1").arg(title));
    setResult(nullptr);
    setFocusProxy(m_choose);
    for (qsizetype i = 1; i < stops().size(); ++i)
        setTabOrder(stops()[i - 1], stops()[i]);
    connect(this, &DropField::fileDropped, this, &PortRow::read);
    connect(this, &DropField::resultDropped, this, &PortRow::resultWanted);
    show();
}

QList<QWidget*> PortRow::stops() const {
    return {m_choose, m_paint, m_useResult, m_extend, m_clear};
}

/// @param narrow whether there are so many buttons that only one has words.
void PortRow::layRow(bool narrow) {
    m_thumbnail = new QLabel(this);
    m_choose = makeButton(QStringLiteral("choose_"), &PortRow::choose);
    m_choose->setText(tr("Choose…"));
    if (narrow)
        setIconButton(m_useResult, QStringLiteral("use-result"), m_useResult->accessibleName());
    else
        m_useResult->setText(tr("Use result"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_thumbnail);
    layout->addWidget(m_name, 1);
    for (QToolButton* button : {m_choose, m_useResult, m_paint, m_extend, m_clear})
        layout->addWidget(button);
}

/// The picture itself is what is clicked to choose another.
void PortRow::layTile(const QString& letter) {
    m_tile = new PictureTile(letter, m_name, translated(m_port.title), this);
    m_choose = m_tile->picture();
    m_choose->setObjectName(QStringLiteral("choose_") + QString::fromStdString(m_port.id));
    connect(m_choose, &QToolButton::clicked, this, &PortRow::choose);
    setIconButton(m_useResult, QStringLiteral("use-result"), m_useResult->accessibleName());
    for (QToolButton* button : {m_paint, m_useResult, m_clear})
        m_tile->add(button);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_tile);
}

QToolButton* PortRow::makeButton(const QString& name, void (PortRow::*clicked)()) {
    auto* button = new QToolButton(this);
    button->setObjectName(name + QString::fromStdString(m_port.id));
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QToolButton::clicked, this, clicked);
    return button;
}

void PortRow::setFiles(std::vector<InputFile> files) {
    m_files = std::move(files);
    show();
}

void PortRow::add(InputFile file) {
    if (static_cast<int>(m_files.size()) >= m_port.most)
        m_files.pop_back();
    m_files.push_back(std::move(file));
    show();
    Q_EMIT edited();
}

QString PortRow::whyNot(const Port& port, const std::shared_ptr<const Result>& result) {
    if (!result)
        return tr("There is no result yet that could go in here; press Run first, or choose a file.");
    return assetFor(result, port) ? QString() : nothingOf(port);
}

void PortRow::setResult(const std::shared_ptr<const Result>& result) {
    const QString why = whyNot(m_port, result);
    m_useResult->setEnabled(why.isEmpty());
    m_useResult->setToolTip(why.isEmpty() ? m_useResult->accessibleName() : why);
}

void PortRow::choose() {
    const QString path =
        QFileDialog::getOpenFileName(window(), translated(m_port.title), {}, filterFor(m_port.kind));
    if (!path.isEmpty())
        read(path);
}

void PortRow::clear() {
    setFiles({});
    Q_EMIT edited();
}

void PortRow::read(const QString& path) {
    const bool picture =
        m_port.kind == AssetKind::Image || m_port.kind == AssetKind::Mask || m_port.kind == AssetKind::Map;
    if (!picture)
        return readLayer(path, {});
    const auto take = [this, path](const std::string& layer) { readLayer(path, layer); };
    inBackground(
        this, [file = toPath(path)] { return layerEntries(readImageInfo(file)); },
        [this, path, take](const std::vector<LayerEntry>& entries) {
            if (entries.empty())
                take({});
            else
                LayerDialog::ask({path, entries, take}, window(), this);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void PortRow::readLayer(const QString& path, const std::string& layer) {
    inBackground(
        this,
        [port = m_port, file = toPath(path), layer, exemplars = m_exemplars] {
            return loadInput(port, {file, "", "", {}, layer}, exemplars);
        },
        [this](InputFile file) { add(std::move(file)); }, [this](const QString& why) { Q_EMIT failed(why); });
}

void PortRow::show() {
    QStringList names, paths;
    for (const InputFile& input : m_files) {
        names += toQString(input.file.path.filename());
        paths += toQString(input.file.path);
    }
    m_name->setFullText(names.isEmpty() ? tr("Nothing") : names.join(QStringLiteral(", ")),
                        paths.join(QLatin1Char('\n')));
    m_clear->setVisible(!m_files.empty());
    const std::shared_ptr<const Image> image = m_files.empty() ? nullptr : m_files.front().file.image;
    if (m_tile != nullptr)
        return m_tile->setImage(image);
    m_thumbnail->setVisible(image != nullptr);
    if (image)
        makeThumbnail(m_thumbnail, image, fontMetrics().lineSpacing() * kThumbnailLines,
                      [this](const QPixmap& made) { m_thumbnail->setPixmap(made); });
}

} // namespace texloom::ui
