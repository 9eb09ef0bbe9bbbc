#pragma once

#include "ui/picture/display_picture.h"

#include <QString>

#include <memory>
#include <string>

namespace texloom::ui {

/// One picture of a comparison.
struct CompareItem {
    QString label; ///< "Image quilting · seed 1 · 512 × 512"
    /// What is shown; null until it is there.
    std::shared_ptr<const DisplayPicture> picture;
    QString message;      ///< said while there is no picture, such as why there will be none
    std::string key;      ///< of the result, whose settings can be taken over; empty for others
    int run = 0;          ///< of the queue, while it is not there yet
    int exemplar = 0;     ///< of the store
    QString figures = {}; ///< what the mouse is told over it, in rich text
};

} // namespace texloom::ui
