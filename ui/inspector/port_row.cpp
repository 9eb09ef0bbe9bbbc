#include "ui/inspector/port_row.h"

#include "core/base/text.h"
#include "core/session/export/output_files.h"
#include "ui/common/background.h"
#include "ui/common/elided_label.h"
#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/picture/display_picture.h"
#include "ui/runs/result_history.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
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

/// A small copy of a picture as it is shown. Called on a worker.
QImage thumbnail(const Image& image, int side) {
    const int step = std::max(1, image.size().longerSide() / side);
    auto small = std::make_shared<Image>(
        Size{(image.width() + step - 1) / step, (image.height() + step - 1) / step}, image.channels());
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < small->height(); ++y)
            for (int x = 0; x < small->width(); ++x)
                (*small)(x, y, c) = image(x * step, y * step, c);
    return DisplayPicture(std::move(small)).image();
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

PortRow::PortRow(const Port& port, QWidget* parent)
    : QWidget(parent), m_port(port), m_thumbnail(new QLabel(this)), m_name(new ElidedLabel(this)),
      m_choose(makeButton(QStringLiteral("choose_"), &PortRow::choose)),
      m_useResult(makeButton(QStringLiteral("useResult_"), &PortRow::useShown)),
      m_paint(makeButton(QStringLiteral("paint_"), &PortRow::paint)),
      m_clear(makeButton(QStringLiteral("clear_"), &PortRow::clear)) {
    const QString title = translated(m_port.title);
    setObjectName(QStringLiteral("port_") + QString::fromStdString(m_port.id));
    setAcceptDrops(true);
    setToolTip(
        QStringLiteral("<b>%1</b> %2").arg(title.toHtmlEscaped(), translated(m_port.help).toHtmlEscaped()));
    m_choose->setText(tr("Choose…"));
    m_choose->setAccessibleName(tr("Choose a file: %1").arg(title));
    m_useResult->setText(tr("Use result"));
    m_useResult->setAccessibleName(tr("Take the result that is shown: %1").arg(title));
    setResult(nullptr);
    setIconButton(m_paint, QStringLiteral("brush"), tr("Paint the mask: %1…").arg(title));
    m_paint->setVisible(m_port.kind == AssetKind::Mask);
    setIconButton(m_clear, QStringLiteral("close"), tr("Go without: %1").arg(title));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_thumbnail);
    layout->addWidget(m_name, 1);
    for (QToolButton* button : {m_choose, m_useResult, m_paint, m_clear})
        layout->addWidget(button);
    setFocusProxy(m_choose);
    show();
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
    inBackground(
        this,
        [port = m_port, file = toPath(path)] {
            return loadInput(port, {file, "", ""}, {});
        },
        [this](InputFile file) { add(std::move(file)); }, [this](const QString& why) { Q_EMIT failed(why); });
}

void PortRow::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedResult(*event->mimeData()).empty() || !localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void PortRow::dropEvent(QDropEvent* event) {
    if (const std::string key = draggedResult(*event->mimeData()); !key.empty())
        Q_EMIT resultWanted(key);
    for (const QString& path : localFiles(*event->mimeData()))
        read(path);
    event->acceptProposedAction();
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
    m_thumbnail->setVisible(!m_files.empty() && m_files.front().image() != nullptr);
    if (!m_thumbnail->isVisibleTo(this))
        return;
    const qreal ratio = devicePixelRatioF();
    const int side = static_cast<int>(fontMetrics().lineSpacing() * kThumbnailLines * ratio);
    inBackground(
        this, [image = m_files.front().file.image, side] { return thumbnail(*image, side); },
        [this, side, ratio](const QImage& made) {
            QPixmap pixmap =
                QPixmap::fromImage(made.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
            pixmap.setDevicePixelRatio(ratio);
            m_thumbnail->setPixmap(pixmap);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

} // namespace texloom::ui
