#pragma once

#include "core/image/image.h"

#include <QPixmap>

#include <functional>
#include <memory>

class QWidget;

namespace texloom::ui {

/// Makes a small picture of an image as it is shown, on a worker, and hands it over unless the widget is gone
/// or was asked for another one meanwhile. @param sides of the square that it fits, in points of the screen.
void makeThumbnail(QWidget* widget, const std::shared_ptr<const Image>& image, int side,
                   const std::function<void(const QPixmap&)>& done);

} // namespace texloom::ui
