#pragma once

#include "core/session/run/input_file.h"

#include <QWidget>

#include <string>
#include <vector>

class QLabel;
class QToolButton;

namespace texloom::ui {

class ElidedLabel;

/// What goes into one of a method's ports: a thumbnail and the file's name, with buttons to choose another,
/// to take the result that is shown, and to go without. Files and results can be dropped on it.
class PortRow : public QWidget {
    Q_OBJECT

public:
    explicit PortRow(const Port& port, QWidget* parent = nullptr);

    const Port& port() const { return m_port; }
    const std::vector<InputFile>& files() const { return m_files; }
    void setFiles(std::vector<InputFile> files);
    /// Takes one more file, or another in place of the one that is there if the port takes no more.
    void add(InputFile file);
    /// Reads a file in the background, and takes it.
    void read(const QString& path);

Q_SIGNALS:
    /// The user chose, dropped or cleared.
    void edited();
    /// A file could not be read.
    void failed(const QString& sentence);
    /// A result is to go into this port: that of this key, or if it is empty the one that is shown.
    void resultWanted(const std::string& key);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QToolButton* makeButton(const QString& name, void (PortRow::*clicked)());
    void choose();
    void clear();
    void useShown() { Q_EMIT resultWanted({}); }
    void show();

    Port m_port;
    std::vector<InputFile> m_files;
    QLabel* m_thumbnail;
    ElidedLabel* m_name;
    QToolButton* m_choose;
    QToolButton* m_useResult;
    QToolButton* m_clear;
};

} // namespace texloom::ui
