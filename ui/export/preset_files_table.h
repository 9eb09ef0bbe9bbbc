#pragma once

#include "core/session/export/export_preset.h"

#include <QTableWidget>

#include <vector>

class QComboBox;

namespace texloom::ui {

/// The files that an export preset writes beside the colours, one a row: the word for $map, what the file
/// holds, as a whole or by channel, and its depth.
class PresetFilesTable : public QTableWidget {
    Q_OBJECT

public:
    enum Column { Word, Holds, Red, Green, Blue, Alpha, DepthColumn };

    explicit PresetFilesTable(QWidget* parent = nullptr);

    void setFiles(const std::vector<PresetFile>& files);
    std::vector<PresetFile> files() const;
    /// Adds a row, and edits its word.
    void addFile();
    void removeFile();

    /// Wide enough for all columns; it scrolls where there is less room.
    QSize sizeHint() const override;

Q_SIGNALS:
    void edited();

private:
    void addRow(const PresetFile& file);
    QComboBox* box(int row, int column) const;
    QComboBox* makeBox(const QString& name);
    void showChannels(int row);
    PresetFile fileIn(int row) const;
    int rowOf(const QWidget* cell) const;

    bool m_filling = false;
};

} // namespace texloom::ui
