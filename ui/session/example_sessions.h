#pragma once

#include <QMenu>
#include <QStringList>

namespace texloom::ui {

/// The sessions that come with Texloom: one for each tool for large textures and families of tiles.
class ExampleSessions : public QMenu {
    Q_OBJECT

public:
    explicit ExampleSessions(QWidget* parent = nullptr);

    /// The sessions' files, by name.
    static QStringList files();

Q_SIGNALS:
    void chosen(const QString& path);

private:
    void add(const QString& path);
};

} // namespace texloom::ui
