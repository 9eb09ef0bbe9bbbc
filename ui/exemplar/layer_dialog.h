#pragma once

#include "core/io/image_file.h"

#include <QDialog>
#include <QString>
#include <QStringList>

#include <string>
#include <vector>

class QListWidget;

namespace texloom::ui {

/// One thing that can be taken from a file.
struct LayerEntry {
    std::string layer; ///< as ReadOptions::layer
    QString title;
};

/// What there is to choose from in a file with several layers, parts or pages; what is taken if nobody
/// chooses comes first. Empty where the file holds one picture.
std::vector<LayerEntry> layerEntries(const ImageFileInfo& info);

/// What is known of a file that waits for someone to choose.
struct LayerQuestion {
    QString path;
    QStringList companions; ///< that come with it
    std::vector<LayerEntry> entries;
};

/// Asks what is to be taken from a file with several layers, parts or pages.
class LayerDialog : public QDialog {
    Q_OBJECT

public:
    explicit LayerDialog(const LayerQuestion& question, QWidget* parent = nullptr);

    /// The one that is chosen, as ReadOptions::layer.
    std::string layer() const;

private:
    QListWidget* m_list;
};

} // namespace texloom::ui
