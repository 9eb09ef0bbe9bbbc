#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QListWidget;

namespace texloom::ui {

class ThumbnailList;

/// What the window shows before there is an exemplar: where to drop one, the files opened last, and those
/// that come with the program.
class StartPage : public QWidget {
    Q_OBJECT

public:
    /// The actions become buttons in the drop zone.
    explicit StartPage(const QList<QAction*>& actions, QWidget* parent = nullptr);

    /// Looks again for recent files and bundled exemplars. Their thumbnails come in by and by.
    void refresh();
    /// Shows that letting go here opens what is dragged.
    void setDropping(bool dropping);

Q_SIGNALS:
    void chosen(const QString& path);

private:
    QWidget* makeDropZone(const QList<QAction*>& actions);
    ThumbnailList* addSection(const QString& title, const QString& name);

    QWidget* m_zone = nullptr;
    QLabel* m_recentTitle = nullptr;
    QLabel* m_bundledTitle = nullptr;
    QListWidget* m_recentList = nullptr;
    QListWidget* m_bundledList = nullptr;
    ThumbnailList* m_recent = nullptr;
    ThumbnailList* m_bundled = nullptr;
};

} // namespace texloom::ui
