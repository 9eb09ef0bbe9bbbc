#include "ui/exemplar/thumbnails.h"

#include "core/session/run/exemplar_file.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/exemplar/resource_folder.h"
#include "ui/picture/display_picture.h"

#include <QFileInfo>
#include <QImageReader>
#include <QListWidget>
#include <QPainter>
#include <QPixmap>

namespace texloom::ui {

namespace {

/// Thumbnails' side in lines of text.
constexpr int kThumbnailLines = 6;
/// Beyond this a file is opened, not shown small.
constexpr std::int64_t kLargestPixels = 64LL << 20;

QImage scaled(const QImage& image, int side) {
    return image.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

/// The picture made small while it is read; none where Qt does not know the format.
QImage readSmall(const QString& path, int side) {
    QImageReader reader(path);
    reader.setAutoTransform(true);
    const QSize size = reader.size();
    if (!size.isValid())
        return {};
    reader.setScaledSize(size.scaled(side, side, Qt::KeepAspectRatio));
    const QImage image = reader.read();
    return image.isNull() ? image : scaled(image, side);
}

/// The thumbnail in the middle of a square, so that names stand in line below.
QIcon squareIcon(const QImage& image, int side) {
    QPixmap square(side, side);
    square.fill(Qt::transparent);
    QPainter painter(&square);
    painter.drawImage((side - image.width()) / 2, (side - image.height()) / 2, image);
    painter.end();
    QIcon icon(square);
    icon.addPixmap(square, QIcon::Selected);
    return icon;
}

} // namespace

QImage thumbnailOf(const QString& path, int side) {
    // Files of others are decoded where one that a library breaks down on does no harm.
    const QString own = resourceFolder(QStringLiteral("exemplars"));
    if (!own.isEmpty() && path.startsWith(own))
        if (QImage image = readSmall(path, side); !image.isNull())
            return image;
    const std::filesystem::path file = toPath(path);
    if (readImageInfo(file).size.area() > kLargestPixels)
        return {};
    return scaled(DisplayPicture(loadExemplar(file).image).image(), side);
}

ThumbnailList::ThumbnailList(QListWidget* list) : QObject(list), m_list(list) {
    const int line = list->fontMetrics().height();
    const int side = line * kThumbnailLines;
    list->setViewMode(QListView::IconMode);
    list->setMovement(QListView::Static);
    list->setResizeMode(QListView::Adjust);
    list->setUniformItemSizes(true);
    list->setTextElideMode(Qt::ElideMiddle);
    list->setWordWrap(false);
    list->setFrameShape(QFrame::NoFrame);
    list->setIconSize({side, side});
    list->setGridSize({side + line, side + line * 2});
    list->viewport()->setAutoFillBackground(false);
    connect(list, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { Q_EMIT chosen(item->data(Qt::UserRole).toString()); });
    connect(list, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { Q_EMIT chosen(item->data(Qt::UserRole).toString()); });
}

bool ThumbnailList::isEmpty() const {
    return m_list->count() == 0;
}

void ThumbnailList::setFiles(const QStringList& paths) {
    m_list->clear();
    const QSize side = m_list->iconSize();
    QPixmap blank(side);
    blank.fill(Qt::transparent);
    for (const QString& path : paths) {
        auto* item = new QListWidgetItem(QIcon(blank), QFileInfo(path).completeBaseName(), m_list);
        item->setData(Qt::UserRole, path);
        item->setToolTip(path);
        item->setSizeHint(m_list->gridSize());
        fetch(path);
    }
}

void ThumbnailList::fetch(const QString& path) {
    const int side = qRound(m_list->iconSize().width() * m_list->devicePixelRatioF());
    const auto show = [this, path, side](const QImage& image) {
        for (int row = 0; row < m_list->count(); ++row)
            if (m_list->item(row)->data(Qt::UserRole).toString() == path && !image.isNull())
                m_list->item(row)->setIcon(squareIcon(image, side));
    };
    inBackground(
        this, [path, side] { return thumbnailOf(path, side); }, show, [](const QString&) {});
}

} // namespace texloom::ui
