#pragma once

#include "core/io/image_file.h"

#include <QDialog>
#include <QString>

#include <functional>
#include <string>
#include <vector>

class QListWidget;

namespace texloom::ui {

/// One thing that can be taken from a file.
struct LayerEntry {
    std::string layer; ///< as ReadOptions::layer
    QString title;
    QString channels = {}; ///< "R, G, B", where the file's header says them
};

/// What there is to choose from in a file with several layers, parts or pages; what is taken if nobody
/// chooses comes first. Empty where the file holds one picture.
std::vector<LayerEntry> layerEntries(const ImageFileInfo& info);

/// A file that waits for someone to choose.
struct LayerQuestion {
    QString path;
    std::vector<LayerEntry> entries;
    std::function<void(const std::string& layer)> take; ///< goes on with the one that was chosen
};

/// Asks what is to be taken from a file with several layers, parts or pages.
class LayerDialog : public QDialog {
    Q_OBJECT

public:
    explicit LayerDialog(const LayerQuestion& question, QWidget* parent = nullptr);
    /// Opens one that goes away by itself. @param context without which nothing is taken.
    static void ask(const LayerQuestion& question, QWidget* parent, const QObject* context);

    /// The one that is chosen, as ReadOptions::layer.
    std::string layer() const;

private:
    QListWidget* m_list;
};

} // namespace texloom::ui
