#include "ui/inspector/thumbnail.h"

#include "ui/common/background.h"
#include "ui/picture/display_picture.h"

#include <QVariant>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr const char* kRequest = "thumbnailRequest"; ///< how many a widget was asked for

/// A small copy of a picture as it is shown.
QImage thumbnailOf(const Image& image, int side) {
    const int step = std::max(1, image.size().longerSide() / side);
    auto small = std::make_shared<Image>(
        Size{(image.width() + step - 1) / step, (image.height() + step - 1) / step}, image.channels());
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < small->height(); ++y)
            for (int x = 0; x < small->width(); ++x)
                (*small)(x, y, c) = image(x * step, y * step, c);
    return DisplayPicture(std::move(small)).image();
}

} // namespace

void makeThumbnail(QWidget* widget, const std::shared_ptr<const Image>& image, int side,
                   const std::function<void(const QPixmap&)>& done) {
    const qreal ratio = widget->devicePixelRatioF();
    const int pixels = static_cast<int>(side * ratio);
    const int request = widget->property(kRequest).toInt() + 1;
    widget->setProperty(kRequest, request);
    inBackground(
        widget, [image, pixels] { return thumbnailOf(*image, pixels); },
        [=](const QImage& made) {
            if (widget->property(kRequest).toInt() != request)
                return;
            QPixmap pixmap = QPixmap::fromImage(
                made.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation));
            pixmap.setDevicePixelRatio(ratio);
            done(pixmap);
        },
        [](const QString&) {});
}

} // namespace texloom::ui
