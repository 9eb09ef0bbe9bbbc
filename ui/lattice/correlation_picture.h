#pragma once

#include "core/analysis/correlation.h"
#include "ui/picture/display_picture.h"

#include <memory>

namespace texloom::ui {

/// γ as a picture, white at the highest of the maxima that can be vectors and black where it is 0; null where
/// there is no γ.
std::shared_ptr<const DisplayPicture> pictureOf(const Correlation& correlation);

} // namespace texloom::ui
