#pragma once

#include "core/session/export/export_preset.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace texloom::ui {

class PresetFilesTable;

/// Edits one's own export presets: what files are called, which maps share one, and where green points in
/// normal maps. Those that Texloom ships are shown, and copied to begin with. Nothing is kept before it is
/// accepted.
class PresetEditor : public QDialog {
    Q_OBJECT

public:
    /// @param chosen the id of the preset that is shown first.
    explicit PresetEditor(const QString& chosen, QWidget* parent = nullptr);

    /// The preset that is shown; its id, once the dialog was accepted.
    QString chosen() const;
    void accept() override;

private:
    QWidget* makeList();
    QWidget* makeForm();
    void fillList(int row);
    void showPreset(int row);
    void add();
    void remove();
    void edit();
    void refresh();
    bool shipped(int row) const;
    const ExportPreset& preset(int row) const;
    int row() const;

    std::vector<ExportPreset> m_own;
    QStringList m_refused; ///< files of presets that cannot be read, with the reasons
    QListWidget* m_list;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLineEdit* m_title;
    QLineEdit* m_pattern;
    QLineEdit* m_color;
    QComboBox* m_normals;
    PresetFilesTable* m_files;
    QPushButton* m_addFile;
    QPushButton* m_removeFile;
    QLabel* m_note;
    QPushButton* m_keep = nullptr;
    bool m_filling = false;
};

} // namespace texloom::ui
