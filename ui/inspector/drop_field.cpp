#include "ui/inspector/drop_field.h"

#include "ui/exemplar/files.h"
#include "ui/runs/result_history.h"

#include <QDragEnterEvent>
#include <QMimeData>

namespace texloom::ui {

void DropField::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedResult(*event->mimeData()).empty() || !localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void DropField::dropEvent(QDropEvent* event) {
    if (const std::string key = draggedResult(*event->mimeData()); !key.empty())
        Q_EMIT resultDropped(key);
    for (const QString& path : localFiles(*event->mimeData()))
        Q_EMIT fileDropped(path);
    event->acceptProposedAction();
}

} // namespace texloom::ui
