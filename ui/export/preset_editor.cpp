#include "ui/export/preset_editor.h"

#include "core/base/error.h"
#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/screen_size.h"
#include "ui/common/text.h"
#include "ui/export/own_presets.h"
#include "ui/export/preset_files_table.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kListWidth = 24, kFileLines = 12; // in letters and lines of text

int shippedCount() {
    return static_cast<int>(exportPresets().size());
}

} // namespace

PresetEditor::PresetEditor(const QString& chosen, QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)), m_add(new QPushButton(tr("&Copy"), this)),
      m_remove(new QPushButton(tr("&Delete"), this)), m_title(new QLineEdit(this)),
      m_pattern(new QLineEdit(this)), m_color(new QLineEdit(this)), m_normals(new QComboBox(this)),
      m_files(new PresetFilesTable(this)), m_addFile(new QPushButton(tr("&Add a file"), this)),
      m_removeFile(new QPushButton(tr("&Remove file"), this)), m_note(new QLabel(this)) {
    setObjectName(QStringLiteral("presetEditor"));
    OwnExportPresets known = OwnExportPresets::read();
    m_own = std::move(known.presets);
    m_refused = known.refused;
    setWindowTitle(tr("Export presets"));
    auto* middle = new QHBoxLayout;
    middle->addWidget(makeList());
    middle->addWidget(makeForm(), 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_keep = buttons->addButton(tr("&Keep"), QDialogButtonBox::AcceptRole);
    m_keep->setObjectName(QStringLiteral("keepPresets"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_note->setObjectName(QStringLiteral("presetNote"));
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    auto* column = new QVBoxLayout(this);
    column->addLayout(middle, 1);
    column->addWidget(m_note);
    column->addWidget(buttons);
    int first = 0;
    for (int row = 0; row < shippedCount() + static_cast<int>(m_own.size()); ++row)
        if (QString::fromStdString(preset(row).id) == chosen)
            first = row;
    fillList(first);
    connect(m_list, &QListWidget::currentRowChanged, this, &PresetEditor::showPreset);
    for (QLineEdit* field : {m_title, m_pattern, m_color})
        connect(field, &QLineEdit::textEdited, this, &PresetEditor::edit);
    connect(m_normals, &QComboBox::activated, this, &PresetEditor::edit);
    connect(m_files, &PresetFilesTable::edited, this, &PresetEditor::edit);
    connect(m_add, &QPushButton::clicked, this, &PresetEditor::add);
    connect(m_remove, &QPushButton::clicked, this, &PresetEditor::remove);
    connect(m_addFile, &QPushButton::clicked, m_files, &PresetFilesTable::addFile);
    connect(m_removeFile, &QPushButton::clicked, m_files, &PresetFilesTable::removeFile);
    showPreset(first);
    resizeWithinScreen(this, sizeHint());
}

QWidget* PresetEditor::makeList() {
    auto* side = new QWidget(this);
    m_list->setObjectName(QStringLiteral("presetList"));
    m_list->setAccessibleName(tr("Export presets"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFixedWidth(fontMetrics().averageCharWidth() * kListWidth);
    m_add->setObjectName(QStringLiteral("addPreset"));
    m_add->setToolTip(tr("A preset of your own that begins as the chosen one is"));
    m_add->setAutoDefault(false);
    m_remove->setObjectName(QStringLiteral("removePreset"));
    m_remove->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_list, 1);
    column->addLayout(buttons);
    return side;
}

QWidget* PresetEditor::makeForm() {
    auto* side = new QWidget(this);
    m_title->setObjectName(QStringLiteral("presetTitle"));
    m_pattern->setObjectName(QStringLiteral("presetPattern"));
    m_pattern->setToolTip(
        tr("The name of the files. $name is the exemplar's, $map the kind of map; there is $method, "
           "$seed, $w, $h, $size and $place, too."));
    m_color->setObjectName(QStringLiteral("presetColor"));
    m_color->setToolTip(tr("The word that stands for $map in the name of the colours; may be empty"));
    m_normals->setObjectName(QStringLiteral("presetNormals"));
    m_normals->addItem(tr("As they are"), static_cast<int>(MapRole::Other));
    m_normals->addItem(tr("OpenGL, green up"), static_cast<int>(MapRole::NormalGl));
    m_normals->addItem(tr("DirectX, green down"), static_cast<int>(MapRole::NormalDx));
    m_files->setMinimumHeight(fontMetrics().height() * kFileLines);
    m_addFile->setObjectName(QStringLiteral("addPresetFile"));
    m_removeFile->setObjectName(QStringLiteral("removePresetFile"));
    for (QPushButton* button : {m_addFile, m_removeFile})
        button->setAutoDefault(false);
    auto* form = new QFormLayout;
    form->addRow(tr("&Title"), m_title);
    form->addRow(tr("&Names of files"), m_pattern);
    form->addRow(tr("C&olours are called"), m_color);
    form->addRow(tr("No&rmals"), m_normals);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_addFile);
    buttons->addWidget(m_removeFile);
    buttons->addStretch();
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(m_files, 1);
    column->addLayout(buttons);
    return side;
}

bool PresetEditor::shipped(int row) const {
    return row < shippedCount();
}

const ExportPreset& PresetEditor::preset(int row) const {
    return shipped(row) ? exportPresets()[static_cast<std::size_t>(row)]
                        : m_own[static_cast<std::size_t>(row - shippedCount())];
}

int PresetEditor::row() const {
    return std::max(0, m_list->currentRow());
}

void PresetEditor::fillList(int row) {
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (const ExportPreset& preset : exportPresets())
        m_list->addItem(translated(preset.title));
    for (const ExportPreset& preset : m_own)
        m_list->addItem(QString::fromStdString(preset.title));
    m_list->setCurrentRow(row);
}

void PresetEditor::showPreset(int row) {
    if (row < 0)
        return;
    const ExportPreset& shown = preset(row);
    const bool own = !shipped(row);
    m_filling = true;
    m_title->setText(own ? QString::fromStdString(shown.title) : translated(shown.title));
    m_pattern->setText(QString::fromStdString(shown.pattern));
    m_color->setText(QString::fromStdString(shown.color));
    m_normals->setCurrentIndex(m_normals->findData(static_cast<int>(shown.normals)));
    m_files->setFiles(shown.files);
    for (QWidget* field : std::initializer_list<QWidget*>{m_title, m_pattern, m_color, m_normals, m_files,
                                                          m_addFile, m_removeFile, m_remove})
        field->setEnabled(own);
    m_filling = false;
    refresh();
}

void PresetEditor::add() {
    ExportPreset copy = preset(row());
    copy.title = tr("%1, copy").arg(m_title->text()).toStdString();
    copy.id.clear();
    m_own.push_back(std::move(copy));
    fillList(shippedCount() + static_cast<int>(m_own.size()) - 1);
    showPreset(m_list->currentRow());
    m_title->setFocus();
    m_title->selectAll();
}

void PresetEditor::remove() {
    if (shipped(row()))
        return;
    m_own.erase(m_own.begin() + (row() - shippedCount()));
    fillList(std::min(row(), shippedCount() + static_cast<int>(m_own.size()) - 1));
    showPreset(m_list->currentRow());
}

void PresetEditor::edit() {
    if (m_filling || shipped(row()))
        return;
    ExportPreset& edited = m_own[static_cast<std::size_t>(row() - shippedCount())];
    edited.title = m_title->text().trimmed().toStdString();
    edited.pattern = m_pattern->text().trimmed().toStdString();
    edited.color = m_color->text().trimmed().toStdString();
    edited.normals = static_cast<MapRole>(m_normals->currentData().toInt());
    edited.files = m_files->files();
    m_list->currentItem()->setText(QString::fromStdString(edited.title));
    refresh();
}

/// Says what is wrong with the first preset that cannot be kept, or of the chosen one, where its file is.
void PresetEditor::refresh() {
    QString wrong;
    for (const ExportPreset& own : m_own)
        try {
            if (wrong.isEmpty())
                checkExportPreset(own);
        } catch (const Error& error) {
            wrong = tr("%1: %2").arg(QString::fromStdString(own.title), translated(error.message()));
        }
    QPalette colors = palette();
    if (!wrong.isEmpty())
        colors.setColor(QPalette::WindowText, errorColor(colors));
    m_note->setPalette(colors);
    m_keep->setEnabled(wrong.isEmpty());
    if (!wrong.isEmpty())
        m_note->setText(wrong);
    else if (shipped(row()))
        m_note->setText((QStringList(tr("This one comes with Texloom. Copy it to change it.")) + m_refused)
                            .join(QLatin1Char('\n')));
    else if (preset(row()).id.empty())
        m_note->setText(tr("New; kept with “Keep”."));
    else
        m_note->setText(tr("On the command line: --export-preset %1")
                            .arg(QDir::toNativeSeparators(OwnExportPresets::fileOf(preset(row())))));
}

void PresetEditor::accept() {
    try {
        keepOwnExportPresets(m_own);
        QDialog::accept();
    } catch (const std::exception& error) {
        m_note->setText(sentence(error));
    }
}

QString PresetEditor::chosen() const {
    return QString::fromStdString(preset(row()).id);
}

} // namespace texloom::ui
