#pragma once

#include <QString>
#include <QWidget>

#include <string>

namespace texloom::ui {

/// A widget on which files and results can be dropped, once setAcceptDrops() says so.
class DropField : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

Q_SIGNALS:
    void fileDropped(const QString& path);
    /// A result of this key in the history was dropped.
    void resultDropped(const std::string& key);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
};

} // namespace texloom::ui
