#include "ui/common/screen_size.h"

#include <QScreen>
#include <QWidget>

namespace texloom::ui {

namespace {

constexpr double kShareForWindow = 0.94; // less a frame

} // namespace

void resizeWithinScreen(QWidget* window, QSize wanted) {
    window->resize(wanted.boundedTo(window->screen()->availableGeometry().size() * kShareForWindow));
}

} // namespace texloom::ui
