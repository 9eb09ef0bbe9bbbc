#include "ui/export/export_dialog.h"

#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "core/session/run/asset_file.h"
#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/icons.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/export/export_table.h"
#include "ui/export/own_presets.h"
#include "ui/export/preset_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kNameWidth = 60;
/// Where the way of the last export is kept.
const QString kLast = QStringLiteral("export/");

} // namespace

ExportDialog::ExportDialog(std::shared_ptr<const Result> result, const QString& folder, QWidget* parent)
    : QDialog(parent), m_result(std::move(result)),
      m_folder(new QLineEdit(QDir::toNativeSeparators(folder), this)), m_preset(new QComboBox(this)),
      m_name(new QLineEdit(this)), m_nameShown(new QLabel(this)), m_normals(new QComboBox(this)),
      m_format(new QComboBox(this)), m_depth(new QComboBox(this)), m_space(new QComboBox(this)),
      m_stMap(new QCheckBox(tr("S&TMap for compositors (EXR)"), this)),
      m_exactMap(new QCheckBox(tr("Exact &positions (16-bit PNG)"), this)),
      m_sidecar(new QCheckBox(tr("&Recipe beside the picture (JSON)"), this)),
      m_companions(new QCheckBox(tr("Companion &maps"), this)), m_table(new ExportTable(this)),
      m_foreign(new QCheckBox(tr("Replace &files that Texloom did not write"), this)),
      m_problem(new QLabel(this)), m_makeFolder(new QPushButton(tr("Create &folder"), this)) {
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export “%1”").arg(QString::fromStdString(m_result->label())));
    m_folder->setObjectName(QStringLiteral("exportFolder"));
    m_folder->setAccessibleName(tr("Folder to write to"));
    m_name->setObjectName(QStringLiteral("exportName"));
    m_preset->setObjectName(QStringLiteral("exportPreset"));
    m_normals->setObjectName(QStringLiteral("exportNormals"));
    m_nameShown->setObjectName(QStringLiteral("exportNameShown"));
    m_name->setMinimumWidth(fontMetrics().averageCharWidth() * kNameWidth);
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_depth->setObjectName(QStringLiteral("exportDepth"));
    m_space->setObjectName(QStringLiteral("exportSpace"));
    m_stMap->setObjectName(QStringLiteral("exportStMap"));
    m_exactMap->setObjectName(QStringLiteral("exportExactMap"));
    m_sidecar->setObjectName(QStringLiteral("exportSidecar"));
    m_companions->setObjectName(QStringLiteral("exportCompanions"));
    m_foreign->setObjectName(QStringLiteral("exportForeign"));
    m_problem->setObjectName(QStringLiteral("exportProblem"));
    m_makeFolder->setObjectName(QStringLiteral("exportMakeFolder"));
    fillFormats();
    followExemplar();
    m_problem->setWordWrap(true);
    m_problem->setTextFormat(Qt::PlainText);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, errorColor(colors));
    m_problem->setPalette(colors);
    auto* column = new QVBoxLayout(this);
    column->addLayout(makeForm());
    column->addWidget(m_table, 1);
    column->addWidget(m_foreign);
    column->addWidget(m_problem);
    column->addWidget(m_makeFolder, 0, Qt::AlignLeft);
    column->addWidget(makeButtons());
    connectFields();
    choosePreset(QSettings().value(kLast + QStringLiteral("preset")).toString());
    refresh();
    countClipped();
    m_name->setFocus();
    m_name->selectAll();
}

/// Format and depth of the exemplar's file, so that nothing of it is lost unasked.
void ExportDialog::followExemplar() {
    const ImageFileInfo& source = m_result->plan.exemplarInfo;
    const QString extension = QString::fromStdString(extensionLike(source));
    m_format->setCurrentIndex(std::max(0, m_format->findData(extension)));
    fillDepths();
    m_depth->setCurrentIndex(std::max(
        0, m_depth->findData(static_cast<int>(depthLike(source, toPath(QStringLiteral("x") + extension))))));
}

void ExportDialog::choosePreset(const QString& id) {
    if (const int known = m_preset->findData(id); known >= 0)
        m_preset->setCurrentIndex(known);
}

void ExportDialog::countClipped() {
    inBackground(
        this, [result = m_result] { return clippedSamples(result->synthesis.image); },
        [this](std::uint64_t count) {
            m_clipped = count;
            if (count > 0)
                refresh();
        },
        [](const QString&) {});
}

void ExportDialog::remember() const {
    QSettings settings;
    const std::pair<const char*, QVariant> values[] = {
        {"preset", m_preset->currentData()}, {"name", m_name->text()},
        {"format", m_format->currentData()}, {"depth", m_depth->currentData()},
        {"space", m_space->currentData()},   {"normals", m_normals->currentData()},
        {"stmap", m_stMap->isChecked()},     {"positions", m_exactMap->isChecked()},
        {"recipe", m_sidecar->isChecked()}};
    for (const auto& [name, value] : values)
        settings.setValue(kLast + QLatin1String(name), value);
}

bool ExportDialog::remembers() {
    return QSettings().contains(kLast + QStringLiteral("name"));
}

void ExportDialog::takeLast() {
    const QSettings settings;
    const auto value = [&settings](const char* name) { return settings.value(kLast + QLatin1String(name)); };
    const auto choose = [&value](QComboBox* box, const char* name) {
        if (const int known = box->findData(value(name)); known >= 0)
            box->setCurrentIndex(known);
    };
    choose(m_preset, "preset");
    m_name->setText(value("name").toString());
    choose(m_format, "format");
    choose(m_depth, "depth");
    choose(m_space, "space");
    choose(m_normals, "normals");
    m_stMap->setChecked(m_stMap->isEnabled() && value("stmap").toBool());
    m_exactMap->setChecked(m_exactMap->isEnabled() && value("positions").toBool());
    m_sidecar->setChecked(value("recipe").toBool());
}

void ExportDialog::makeFolder() {
    if (!QDir().mkpath(folder()))
        m_problem->setText(tr("The folder %1 cannot be made.").arg(folder()));
    else
        refresh();
}

/// What a file holds, and how many of its values the depth cuts off.
QString ExportDialog::holds(const ExportEntry& entry) const {
    QString content = translated(entry.content);
    const bool whole = entry.depth == Depth::Bits8 || entry.depth == Depth::Bits16;
    if (entry.path != options().image || m_clipped == 0 || !whole)
        return content;
    return tr("%1, %2 values clipped").arg(content, QLocale().toString(static_cast<qulonglong>(m_clipped)));
}

void ExportDialog::presetChosen() {
    m_name->setText(QString::fromStdString(preset().pattern));
    m_table->forgetDepths();
    refresh();
}

QString ExportDialog::nameFor(const std::string& map) const {
    return QString::fromStdString(
               expandName(m_name->text().trimmed().toStdString(), nameWords(*m_result, map)))
        .trimmed();
}

void ExportDialog::fillFormats() {
    fillPresets();
    m_preset->setToolTip(
        tr("What the files are called, which maps share one, and where green points in normal "
           "maps."));
    m_name->setText(QString::fromStdString(exportPresets().front().pattern));
    m_name->setToolTip(
        tr("The name of the files. $name is the exemplar's, $map the kind of map; there is $method, "
           "$seed, $w, $h, $size and $place, too."));
    m_normals->addItem(tr("As the preset says"), static_cast<int>(MapRole::Other));
    m_normals->addItem(tr("OpenGL, green up"), static_cast<int>(MapRole::NormalGl));
    m_normals->addItem(tr("DirectX, green down"), static_cast<int>(MapRole::NormalDx));
    m_format->addItem(tr("PNG"), QStringLiteral(".png"));
    m_format->addItem(tr("TIFF"), QStringLiteral(".tif"));
    m_format->addItem(tr("OpenEXR"), QStringLiteral(".exr"));
    m_format->addItem(tr("JPEG"), QStringLiteral(".jpg"));
    m_format->addItem(tr("Radiance HDR"), QStringLiteral(".hdr"));
    m_space->addItem(tr("Automatic"), QString());
    for (const ColorSpace& space : color::spaces())
        m_space->addItem(translated(space.title), QString::fromStdString(space.id));
    m_space->setToolTip(tr("Automatic: sRGB, or linear for depths that hold it."));
}

void ExportDialog::fillPresets() {
    m_presets = exportPresets();
    const std::size_t shipped = m_presets.size();
    const OwnExportPresets own = OwnExportPresets::read();
    m_presets.insert(m_presets.end(), own.presets.begin(), own.presets.end());
    const QSignalBlocker blocker(m_preset);
    m_preset->clear();
    for (std::size_t i = 0; i < m_presets.size(); ++i)
        m_preset->addItem(i < shipped ? translated(m_presets[i].title)
                                      : QString::fromStdString(m_presets[i].title),
                          QString::fromStdString(m_presets[i].id));
}

QWidget* ExportDialog::makePresetRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* edit = new QToolButton(row);
    edit->setObjectName(QStringLiteral("exportEditPresets"));
    edit->setText(tr("Edit…"));
    edit->setToolTip(tr("Make and change presets of your own"));
    edit->setAccessibleName(tr("Edit export presets"));
    edit->setFocusPolicy(Qt::StrongFocus);
    connect(edit, &QToolButton::clicked, this, &ExportDialog::editPresets);
    layout->addWidget(m_preset, 1);
    layout->addWidget(edit);
    return row;
}

void ExportDialog::editPresets() {
    auto* editor = new PresetEditor(m_preset->currentData().toString(), this);
    editor->setAttribute(Qt::WA_DeleteOnClose);
    connect(editor, &QDialog::accepted, this, [this, editor] {
        fillPresets();
        choosePreset(editor->chosen());
        presetChosen();
    });
    editor->open();
}

const ExportPreset& ExportDialog::preset() const {
    return m_presets[static_cast<std::size_t>(std::max(0, m_preset->currentIndex()))];
}

void ExportDialog::fillDepths() {
    m_depth->clear();
    for (const Depth depth : depthsFor(toPath(QStringLiteral("x") + m_format->currentData().toString())))
        m_depth->addItem(depthText(depth), static_cast<int>(depth));
    m_depth->setEnabled(m_depth->count() > 1);
}

QWidget* ExportDialog::makeFolderRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QToolButton(row);
    choose->setText(tr("Choose…"));
    choose->setAccessibleName(tr("Choose a folder"));
    choose->setFocusPolicy(Qt::StrongFocus);
    connect(choose, &QToolButton::clicked, this, &ExportDialog::chooseFolder);
    layout->addWidget(m_folder, 1);
    layout->addWidget(choose);
    return row;
}

void ExportDialog::makeChecks() {
    const bool map = m_result->synthesis.mapKind != MapKind::None;
    for (QCheckBox* box : {m_stMap, m_exactMap}) {
        box->setEnabled(map);
        if (!map)
            box->setToolTip(tr("This method makes new pixels, so there is no map of where they came from."));
    }
    m_sidecar->setChecked(true);
    m_sidecar->setToolTip(tr("All settings, to make the same result again."));
    m_companions->setChecked(m_result->plan.hasCompanions());
    m_companions->setVisible(m_result->plan.hasCompanions());
}

QFormLayout* ExportDialog::makeForm() {
    makeChecks();
    auto* form = new QFormLayout;
    QWidget* const folderRow = makeFolderRow();
    form->addRow(tr("&Folder"), folderRow);
    qobject_cast<QLabel*>(form->labelForField(folderRow))->setBuddy(m_folder);
    QWidget* const presetRow = makePresetRow();
    form->addRow(tr("&Preset"), presetRow);
    qobject_cast<QLabel*>(form->labelForField(presetRow))->setBuddy(m_preset);
    form->addRow(tr("&Name"), m_name);
    form->addRow(QString(), m_nameShown);
    form->addRow(tr("F&ormat"), m_format);
    form->addRow(tr("&Depth"), m_depth);
    form->addRow(tr("&Colour space"), m_space);
    const std::vector<std::vector<ExemplarFile>>& maps = m_result->plan.companions;
    const bool normals = m_result->plan.hasCompanions() &&
                         std::any_of(maps.front().begin(), maps.front().end(),
                                     [](const ExemplarFile& file) { return isNormal(file.role); });
    if (normals)
        form->addRow(tr("Norm&als"), m_normals);
    m_normals->setVisible(normals);
    form->addRow(tr("Position map"), m_stMap);
    form->addRow(QString(), m_exactMap);
    form->addRow(tr("Also"), m_sidecar);
    form->addRow(QString(), m_companions);
    addOutputs(form);
    return form;
}

/// A row for each further output; volumes may be large, and are written only where that is wanted.
void ExportDialog::addOutputs(QFormLayout* form) {
    std::map<std::string, std::filesystem::path> all;
    for (const auto& [port, assets] : m_result->synthesis.outputs.byPort())
        if (outputPort(m_result->plan, port) != nullptr)
            all.emplace(port, std::filesystem::path());
    for (const OutputFile& output : outputFiles(*m_result, all)) {
        if (!m_outputs.empty() && m_outputs.back().output.port == output.port)
            continue; // several of one port are written together
        const bool volume = output.port->kind == AssetKind::Volume;
        OutputRow row{output, new QCheckBox(translated(output.content()), this)};
        row.box->setObjectName(QStringLiteral("export_") + QString::fromStdString(output.port->id));
        row.box->setToolTip(translated(output.port->help));
        row.box->setChecked(!volume);
        form->addRow(QString(), row.box);
        if (volume) {
            row.format = volumeFormats(output);
            row.format->setEnabled(false);
            connect(row.box, &QCheckBox::toggled, row.format, &QWidget::setEnabled);
            form->addRow(tr("Written as"), row.format);
        }
        m_outputs.push_back(row);
    }
}

QComboBox* ExportDialog::volumeFormats(const OutputFile& output) {
    auto* formats = new QComboBox(this);
    formats->setObjectName(QStringLiteral("format_") + QString::fromStdString(output.port->id));
    formats->addItem(tr("Raw numbers with JSON"), QStringLiteral(".json"));
    formats->addItem(tr("Slices as PNG"), QStringLiteral(".png"));
    formats->addItem(tr("Slices as TIFF"), QStringLiteral(".tif"));
    formats->addItem(tr("Slices as OpenEXR"), QStringLiteral(".exr"));
    const AssetWriteOptions write = outputOptions(*m_result, output);
    const auto source = std::get<std::shared_ptr<const VolumeSource>>(*output.asset);
    const VolumeSize size = keptBox(*source, write.size, write.mostVoxels).size;
    formats->setToolTip(tr("%1 voxels are written.").arg(QString::fromStdString(texloom::sizeText(size))));
    return formats;
}

QWidget* ExportDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_write = buttons->addButton(tr("&Write files"), QDialogButtonBox::AcceptRole);
    m_write->setObjectName(QStringLiteral("exportWrite"));
    m_write->setIcon(icon(QStringLiteral("export")));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void ExportDialog::connectFields() {
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] {
        fillDepths();
        refresh();
    });
    connect(m_makeFolder, &QPushButton::clicked, this, &ExportDialog::makeFolder);
    for (QLineEdit* edit : {m_folder, m_name})
        connect(edit, &QLineEdit::textChanged, this, &ExportDialog::refresh);
    connect(m_preset, &QComboBox::currentIndexChanged, this, &ExportDialog::presetChosen);
    for (QComboBox* combo : {m_depth, m_space, m_normals})
        connect(combo, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    std::vector<QCheckBox*> boxes = {m_stMap, m_exactMap, m_sidecar, m_companions, m_foreign};
    for (const OutputRow& row : m_outputs) {
        boxes.push_back(row.box);
        if (row.format != nullptr)
            connect(row.format, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    }
    for (QCheckBox* box : boxes)
        connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
}

QString ExportDialog::folder() const {
    return QDir::fromNativeSeparators(m_folder->text().trimmed());
}

ExportOptions ExportDialog::options() const {
    const std::string pattern = m_name->text().trimmed().toStdString();
    const bool holdsMap =
        pattern.find("$map") != std::string::npos || pattern.find("${map}") != std::string::npos;
    ExportOptions options;
    options.preset = preset();
    options.pattern = holdsMap ? pattern : "";
    options.normals = static_cast<MapRole>(m_normals->currentData().toInt());
    options.mayReplace = m_table->replaced();
    const QString place = folder() + QLatin1Char('/');
    options.image = toPath(place + nameFor(options.preset.color) + m_format->currentData().toString());
    const auto besideIt = [&](const char* word, const char* extension) {
        const QString name = holdsMap ? nameFor(word) : nameFor("") + QLatin1Char('_') + QLatin1String(word);
        return toPath(place + name + QLatin1String(extension));
    };
    options.depth = static_cast<Depth>(m_depth->currentData().toInt());
    options.space = m_space->currentData().toString().toStdString();
    options.sidecar = m_sidecar->isChecked();
    if (m_stMap->isChecked())
        options.maps.push_back(besideIt("stmap", ".exr"));
    if (m_exactMap->isChecked())
        options.maps.push_back(besideIt("map", ".png"));
    options.companions = m_companions->isChecked();
    options.depths = m_table->depths();
    for (const OutputRow& row : m_outputs)
        if (row.box->isChecked()) {
            const std::string extension = row.format != nullptr
                                              ? row.format->currentData().toString().toStdString()
                                              : usualExtension(*row.output.port);
            options.outputs[row.output.port->id] = besideIt(row.output.port->id.c_str(), extension.c_str());
        }
    return options;
}

QString ExportDialog::refusal() const {
    const QString name = m_name->text().trimmed();
    if (name.isEmpty())
        return tr("The files need a name.");
    if (name.contains(QLatin1Char('/')))
        return tr("The name cannot hold a slash; choose the folder above.");
    if (folder().isEmpty())
        return tr("Choose the folder to write to.");
    if (!QDir(folder()).exists())
        return tr("The folder %1 is not there.").arg(folder());
    try {
        if (nameFor("x").isEmpty())
            return tr("The files need a name.");
        checkWritable(options().image, m_result->synthesis.image.channels(), options().depth);
        const std::vector<ExportEntry> entries = exportEntries(*m_result, options());
        OutputGuard guard = FilesInUse::all().now();
        for (const ExportEntry& entry : entries)
            guard.writes(entry.path, Message(entry.content));
        guard.check(true);
        for (const ExportEntry& entry : entries)
            if (entry.foreign && !m_foreign->isChecked())
                return tr("%1 is there, and Texloom did not write it. Choose another name or folder, or "
                          "allow that it is replaced.")
                    .arg(toQString(entry.path.filename()));
    } catch (const std::exception& error) {
        return sentence(error);
    }
    return {};
}

void ExportDialog::refresh() {
    const QString problem = refusal();
    m_makeFolder->setVisible(!folder().isEmpty() && !QDir(folder()).exists());
    m_problem->setVisible(!problem.isEmpty());
    m_problem->setText(problem);
    m_write->setEnabled(problem.isEmpty());
    m_write->setToolTip(problem);
    if (problem.isEmpty())
        m_nameShown->setText(tr("→ %1").arg(toQString(options().image.filename())));
    else
        m_nameShown->clear();
    const std::vector<ExportEntry> files = entries();
    m_foreign->setVisible(
        std::any_of(files.begin(), files.end(), [](const ExportEntry& entry) { return entry.foreign; }));
    m_table->fill(files, [this](const ExportEntry& entry) { return holds(entry); });
}

std::vector<ExportEntry> ExportDialog::entries() const {
    try {
        return exportEntries(*m_result, options());
    } catch (const Error&) {
        return {};
    }
}

void ExportDialog::chooseFolder() {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Export to"), folder());
    if (!chosen.isEmpty())
        m_folder->setText(QDir::toNativeSeparators(chosen));
}

} // namespace texloom::ui
