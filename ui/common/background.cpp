#include "ui/common/background.h"

#include "core/base/error.h"
#include "ui/common/text.h"

#include <new>

namespace texloom::ui {

QThreadPool& workers() {
    static QThreadPool pool;
    return pool;
}

QString sentence(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return QCoreApplication::translate("background",
                                           "There is not enough memory for this; close an image or "
                                           "choose a smaller one.");
    return translated(messageOf(error));
}

} // namespace texloom::ui
