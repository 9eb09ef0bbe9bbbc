#pragma once

#include <QIcon>
#include <QObject>
#include <QString>

class QListWidget;
class QListWidgetItem;

namespace texloom::ui {

/// A small picture of a file, at most `side` pixels on each side. Called on a worker. @throws Error
QImage thumbnailOf(const QString& path, int side);

/// Shows files as pictures with their names, to be opened with a click or Return. The pictures come in one by
/// one from a worker.
class ThumbnailList : public QObject {
    Q_OBJECT

public:
    /// @param list an empty list widget, which is made to show thumbnails.
    explicit ThumbnailList(QListWidget* list);

    void setFiles(const QStringList& paths);
    bool isEmpty() const;

Q_SIGNALS:
    void chosen(const QString& path);

private:
    void fetch(const QString& path);

    QListWidget* m_list;
};

} // namespace texloom::ui
