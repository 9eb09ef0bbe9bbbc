#pragma once

#include "core/session/run/input_file.h"
#include "ui/inspector/drop_field.h"

#include <QList>

#include <memory>
#include <string>
#include <utility>
#include <vector>

class QLabel;
class QToolButton;

namespace texloom {
struct Result;
}

namespace texloom::ui {

class ElidedLabel;
class PictureTile;

/// How what goes into a port is shown, and what can be done about it beside choosing.
struct PortLook {
    bool tile = false;    ///< as a cell, rather than as a row
    QString letter = {};  ///< of a cell
    bool paints = false;  ///< it can be painted
    bool extends = false; ///< the picture that this mask belongs to can be made larger
};

/// What goes into one of a method's ports: a thumbnail and the file's name, with buttons to choose another,
/// to take the result that is shown, to paint it, to extend the picture that it belongs to, and to go
/// without. Files and results can be dropped on it.
class PortRow : public DropField {
    Q_OBJECT

public:
    explicit PortRow(const Port& port, const PortLook& look = {}, QWidget* parent = nullptr);

    const Port& port() const { return m_port; }
    const std::vector<InputFile>& files() const { return m_files; }
    void setFiles(std::vector<InputFile> files);
    /// Takes one more file, or another in place of the one that is there if the port takes no more.
    void add(InputFile file);
    /// The result that is shown, which can be taken if it has something of the port's kind; null if there is
    /// none.
    void setResult(const std::shared_ptr<const Result>& result);
    /// Why nothing of a result can go into a port, in a sentence; empty if something can. @param result null
    /// if there is none.
    static QString whyNot(const Port& port, const std::shared_ptr<const Result>& result);
    /// Reads a file in the background, and takes it. Of a picture with several layers asks which.
    void read(const QString& path);
    /// The sizes of the exemplars in use, which position maps of other programs point into without saying so.
    void setExemplarSizes(std::vector<Size> sizes) { m_exemplars = std::move(sizes); }
    /// Its controls in the order of the tab key; the first is its focus proxy.
    QList<QWidget*> stops() const;

Q_SIGNALS:
    /// The user chose, dropped or cleared.
    void edited();
    /// A file could not be read.
    void failed(const QString& sentence);
    /// A result is to go into this port: that of this key, or if it is empty the one that is shown.
    void resultWanted(const std::string& key);
    /// What goes into this port is to be painted.
    void paintWanted();
    /// The picture that this mask belongs to is to be made larger.
    void extendWanted();

private:
    QToolButton* makeButton(const QString& name, void (PortRow::*clicked)());
    void choose();
    void clear();
    void readLayer(const QString& path, const std::string& layer);
    void useShown() { Q_EMIT resultWanted({}); }
    void paint() { Q_EMIT paintWanted(); }
    void extend() { Q_EMIT extendWanted(); }
    void layRow(bool narrow);
    void layTile(const QString& letter);
    void show();

    Port m_port;
    std::vector<InputFile> m_files;
    std::vector<Size> m_exemplars;
    QLabel* m_thumbnail = nullptr; ///< of a row
    PictureTile* m_tile = nullptr; ///< of a cell
    ElidedLabel* m_name;
    QToolButton* m_choose = nullptr;
    QToolButton* m_useResult;
    QToolButton* m_paint;
    QToolButton* m_extend;
    QToolButton* m_clear;
};

} // namespace texloom::ui
