#pragma once

#include "core/session/export/export.h"
#include "core/session/export/output_files.h"

#include <QDialog>

#include <memory>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace texloom::ui {

class ExportTable;

/// Asks where and how to write a result, and shows every file before it is written: what it holds, and
/// whether it replaces one that is there. Writing is up to whoever opened the dialog, off the GUI thread.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(std::shared_ptr<const Result> result, const QString& folder, QWidget* parent = nullptr);

    /// What is asked for as the dialog stands.
    ExportOptions options() const;
    /// Why it cannot be written; empty if it can.
    QString refusal() const;
    const std::shared_ptr<const Result>& result() const { return m_result; }
    QString folder() const;
    /// Notes what was chosen, for the next dialog and takeLast().
    void remember() const;
    /// Whether something was noted.
    static bool remembers();
    /// Takes all of it, with format and depth, which else follow the exemplar's file.
    void takeLast();

private:
    /// One of the result's further outputs, such as a model or a volume.
    struct OutputRow {
        OutputFile output; ///< without a path
        QCheckBox* box = nullptr;
        QComboBox* format = nullptr; ///< of volumes: the extension that they are written with
    };

    void makeChecks();
    void addOutputs(QFormLayout* form);
    QComboBox* volumeFormats(const OutputFile& output);
    QFormLayout* makeForm();
    QWidget* makeButtons();
    void connectFields();
    QWidget* makeFolderRow();
    void fillFormats();
    void fillDepths();
    void followExemplar();
    void choosePreset(const QString& id);
    QWidget* makePresetRow();
    void fillPresets();
    void editPresets();
    const ExportPreset& preset() const;
    void countClipped();
    void makeFolder();
    QString holds(const ExportEntry& entry) const;
    void refresh();
    /// Every file as it would be written now; none while something is wrong.
    std::vector<ExportEntry> entries() const;
    void chooseFolder();
    void presetChosen();
    /// The name for one kind of map, from the template in the name's field. @throws UsageError
    QString nameFor(const std::string& map) const;

    std::shared_ptr<const Result> m_result;
    std::vector<ExportPreset> m_presets; ///< those that Texloom ships, then one's own
    QLineEdit* m_folder;
    QComboBox* m_preset;
    QLineEdit* m_name;
    QLabel* m_nameShown;
    QComboBox* m_normals;
    QComboBox* m_format;
    QComboBox* m_depth;
    QComboBox* m_space;
    QCheckBox* m_stMap;
    QCheckBox* m_exactMap;
    QCheckBox* m_sidecar;
    QCheckBox* m_companions;
    std::vector<OutputRow> m_outputs;
    ExportTable* m_table;
    QCheckBox* m_foreign; ///< shown where files of others would be replaced
    QLabel* m_problem;
    QPushButton* m_makeFolder;   ///< shown where the folder is not there
    std::uint64_t m_clipped = 0; ///< samples of the result that whole numbers cut off
    QPushButton* m_write = nullptr;
};

} // namespace texloom::ui
