#include "ui/blend/blend_window.h"

#include "ui/common/save_guard.h"
#include "ui/common/screen_size.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/exemplar/files.h"
#include "ui/jobs/task_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace texloom::ui {

namespace {

constexpr std::chrono::milliseconds kPause{150};
constexpr int kWidth = 150, kLines = 44; ///< of the window, in widths and lines of text
constexpr std::size_t kShownFirst = 4;   ///< ways that are shown at first

/// The tools that join two pictures.
std::vector<const Tool*> joiningTools() {
    std::vector<const Tool*> joining;
    for (const Tool& tool : tools())
        if (tool.joins())
            joining.push_back(&tool);
    return joining;
}

/// The first two images that can be joined as they are: of as many channels. What is not at hand yet is taken
/// only where there is no such pair.
std::optional<std::pair<int, int>> suitingPair(const std::vector<NamedImage>& images) {
    const auto count = static_cast<int>(images.size());
    const auto at = [&](int i) { return images[static_cast<std::size_t>(i)].file.image; };
    for (int first = 0; first < count; ++first)
        for (int second = first + 1; second < count; ++second)
            if (at(first) && at(second) && at(first)->channels() == at(second)->channels())
                return std::pair(first, second);
    return count > 1 ? std::optional(std::pair(0, 1)) : std::nullopt;
}

void share(ImageViewer* from, ImageViewer* to) {
    QObject::connect(from, &ImageViewer::viewChanged, to, [from, to] {
        const QSignalBlocker blocker(to);
        if (from->picture() && to->picture() && from->picture()->size() == to->picture()->size())
            to->setView(from->view(), from->fitted());
    });
}

} // namespace

BlendWindow::BlendWindow(const std::vector<NamedImage>& images, QWidget* parent)
    : QDialog(parent), m_tool(joiningTools().front()), m_tools(new QComboBox), m_showHandle(new QCheckBox),
      m_ways(new QWidget), m_grid(new QGridLayout), m_message(new QLabel), m_bar(new TaskBar),
      m_paint(new QPushButton(tr("&Paint the region…"))), m_save(new QPushButton(tr("&Save"))),
      m_use(new QPushButton(tr("Open as e&xemplar"))) {
    setObjectName(QStringLiteral("blendWindow"));
    setWindowTitle(tr("Blend two images"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kPause);
    connect(&m_soon, &QTimer::timeout, this, &BlendWindow::blendNow);
    auto* content = new QHBoxLayout;
    content->addWidget(makeOptions());
    content->addLayout(m_grid, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(content, 1);
    column->addWidget(makeBottom());
    for (const NamedImage& image : images)
        addImage(image);
    if (const auto pair = suitingPair(images)) {
        m_choice[0]->setCurrentIndex(pair->first);
        m_choice[1]->setCurrentIndex(pair->second);
    }
    for (QComboBox* choice : m_choice)
        connect(choice, &QComboBox::currentIndexChanged, this, &BlendWindow::changed);
    FilesInUse::all().add(this, [this](OutputGuard& guard) {
        for (const std::unique_ptr<NamedImage>& image : m_images)
            if (!image->file.path.empty())
                guard.reads(image->file.path, TR("a picture to blend"));
    });
    resizeWithinScreen(this, {fontMetrics().averageCharWidth() * kWidth, fontMetrics().height() * kLines});
    setTool(*m_tool);
}

QWidget* BlendWindow::makeOptions() {
    auto* options = new QWidget(this);
    auto* form = new QFormLayout(options);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&First"), makeImageRow(0));
    qobject_cast<QLabel*>(form->labelForField(m_choice[0]->parentWidget()))->setBuddy(m_choice[0]);
    form->addRow(tr("S&econd"), makeImageRow(1));
    qobject_cast<QLabel*>(form->labelForField(m_choice[1]->parentWidget()))->setBuddy(m_choice[1]);
    m_tools->setObjectName(QStringLiteral("blendTool"));
    for (const Tool* tool : joiningTools())
        m_tools->addItem(translated(tool->info().title));
    form->addRow(tr("&Tool"), m_tools);
    form->setRowVisible(m_tools, m_tools->count() > 1);
    auto* rows = new QWidget(options);
    m_rowForm = new QFormLayout(rows);
    m_rowForm->setContentsMargins(0, 0, 0, 0);
    m_rowForm->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(rows);
    form->addRow(QString(), m_paint);
    m_paint->setObjectName(QStringLiteral("blendPaint"));
    m_paint->setAutoDefault(false);
    connect(m_paint, &QPushButton::clicked, this, &BlendWindow::paintRegion);
    new QVBoxLayout(m_ways);
    m_ways->layout()->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Show"), m_ways);
    m_showHandle->setChecked(true);
    form->addRow(QString(), m_showHandle);
    connect(m_tools, &QComboBox::currentIndexChanged, this,
            [this](int index) { setTool(*joiningTools().at(static_cast<std::size_t>(index))); });
    connect(m_showHandle, &QCheckBox::toggled, this, &BlendWindow::showHandle);
    return options;
}

void BlendWindow::setTool(const Tool& tool) {
    m_tool = &tool;
    m_task.cancel();
    const std::vector<const Tool*> joining = joiningTools();
    const QSignalBlocker blocker(m_tools);
    m_tools->setCurrentIndex(
        static_cast<int>(std::find(joining.begin(), joining.end(), m_tool) - joining.begin()));
    m_tools->setToolTip(translated(tool.info().summary));
    makeRows();
    makeCells();
    fillSaveMenu();
    m_showHandle->setVisible(tool.info().handle != ToolHandle::None);
    m_showHandle->setText(tool.info().handle == ToolHandle::Offset ? tr("Show the re&gion’s outline")
                                                                   : tr("Show the cur&ve and its band"));
    m_paint->setVisible(tool.info().region.has_value());
    m_paint->setToolTip(tool.info().region ? translated(tool.info().region->help) : QString());
    arrange();
    changed();
}

void BlendWindow::setValues(const Values& values) {
    for (const Row& row : m_rows)
        if (const auto value = values.find(row.param->name()); value != values.end())
            row.editor->setValue(value->second);
    changed();
}

/// An editor for each parameter that no way sets.
void BlendWindow::makeRows() {
    m_rows.clear();
    while (m_rowForm->rowCount() > 0)
        m_rowForm->removeRow(0);
    const std::vector<ToolPreset>& ways = m_tool->info().presets;
    for (const Param& param : m_tool->params()) {
        if (std::any_of(ways.begin(), ways.end(),
                        [&](const ToolPreset& way) { return way.values.contains(param.name()); }))
            continue;
        ValueEditor* const editor = makeValueEditor(param, m_rowForm->parentWidget());
        editor->setObjectName(QStringLiteral("blend-%1").arg(QString::fromStdString(param.name())));
        editor->setAccessibleName(translated(param.title()));
        editor->setToolTip(translated(param.help()));
        editor->setValue(param.defaultFor(0));
        auto* label = new QLabel(translated(param.title()));
        label->setBuddy(editor);
        m_rowForm->addRow(label, editor);
        m_rows.push_back({&param, editor});
        connect(editor, &ValueEditor::edited, this, &BlendWindow::changed);
    }
}

QWidget* BlendWindow::makeImageRow(int which) {
    auto* row = new QWidget;
    auto* choice = new QComboBox(row);
    m_choice[static_cast<std::size_t>(which)] = choice;
    choice->setObjectName(which == 0 ? QStringLiteral("blendFirst") : QStringLiteral("blendSecond"));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(16);
    auto* open = new QPushButton(tr("Open…"), row);
    open->setAccessibleName(which == 0 ? tr("Open a file as the first image")
                                       : tr("Open a file as the second image"));
    open->setAutoDefault(false);
    connect(open, &QPushButton::clicked, this, [this, which] { openFile(which); });
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(choice, 1);
    layout->addWidget(open);
    return row;
}

void BlendWindow::makeCells() {
    for (const Cell& cell : m_cells) {
        delete cell.viewer;
        delete cell.shown;
    }
    m_cells.clear();
    for (const ToolPreset& way : m_tool->info().presets)
        addCell(translated(way.title), translated(way.help), way.values);
    if (m_cells.empty())
        addCell(translated(m_tool->info().title), translated(m_tool->info().summary), {});
    for (const Cell& from : m_cells)
        for (const Cell& to : m_cells)
            if (from.viewer != to.viewer)
                share(from.viewer, to.viewer);
}

void BlendWindow::addCell(const QString& title, const QString& help, const Values& values) {
    ImageViewer* const viewer = makeViewer();
    viewer->setAccessibleName(title);
    viewer->setPlaceholder(tr("Choose two images."));
    auto* shown = new QCheckBox(title, m_ways);
    shown->setToolTip(help);
    shown->setObjectName(QStringLiteral("blendWay%1").arg(m_cells.size()));
    shown->setChecked(m_cells.size() < kShownFirst);
    m_ways->layout()->addWidget(shown);
    connect(shown, &QCheckBox::toggled, this, [this] {
        arrange();
        changed();
    });
    m_cells.push_back({title, values, viewer, shown});
}

/// A viewer with what the mouse can move of this tool.
ImageViewer* BlendWindow::makeViewer() {
    switch (m_tool->info().handle) {
    case ToolHandle::Curve: {
        auto* viewer = new CurveViewer(this);
        connect(viewer, &CurveViewer::positionDragged, this, [this](double position) {
            editorOf("position")->setValue(position);
            changed();
        });
        return viewer;
    }
    case ToolHandle::Offset: {
        auto* viewer = new RegionViewer(this);
        connect(viewer, &RegionViewer::offsetDragged, this, [this](QPoint offset) {
            editorOf("offset-x")->setValue(offset.x());
            editorOf("offset-y")->setValue(offset.y());
            changed();
        });
        return viewer;
    }
    case ToolHandle::None:
        break;
    }
    return new ImageViewer(this);
}

QWidget* BlendWindow::makeBottom() {
    m_message->setObjectName(QStringLiteral("blendMessage"));
    m_message->setWordWrap(true);
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_save->setObjectName(QStringLiteral("blendSave"));
    m_save->setMenu(new QMenu(m_save));
    m_use->setObjectName(QStringLiteral("blendUse"));
    m_use->hide();
    connect(m_use, &QPushButton::clicked, this, [this] { Q_EMIT exemplarWanted(m_written); });
    auto* close = new QPushButton(tr("Close"));
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    for (QPushButton* button : {m_save, m_use, close})
        button->setAutoDefault(false);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_task.cancel();
        m_bar->end();
        say(tr("Stopped. The pictures are those of earlier settings; any change starts again."));
    });
    auto* bottom = new QWidget(this);
    auto* row = new QHBoxLayout(bottom);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_message, 1);
    row->addWidget(m_bar, 1);
    row->addWidget(m_use);
    row->addWidget(m_save);
    row->addWidget(close);
    return bottom;
}

void BlendWindow::addImage(const NamedImage& image) {
    m_images.push_back(std::make_unique<NamedImage>(image));
    for (QComboBox* choice : m_choice)
        choice->addItem(image.title);
}

void BlendWindow::choose(int which, const NamedImage& image) {
    addImage(image);
    m_choice[static_cast<std::size_t>(which)]->setCurrentIndex(static_cast<int>(m_images.size()) - 1);
    changed();
}

void BlendWindow::openFile(int which) {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open an image"), QSettings().value(kBlendFolder).toString(), pictureFilter());
    if (path.isEmpty())
        return;
    QSettings().setValue(kBlendFolder, QFileInfo(path).path());
    inBackground(
        this, [file = toPath(path)] { return loadExemplar(file); },
        [this, which](ExemplarFile file) {
            const QString name = QString::fromStdString(file.name());
            choose(which, {name, std::move(file)});
        },
        [this](const QString& why) { say(why); });
}

const NamedImage* BlendWindow::chosen(int which) const {
    const int index = m_choice[static_cast<std::size_t>(which)]->currentIndex();
    return index < 0 ? nullptr : m_images[static_cast<std::size_t>(index)].get();
}

bool BlendWindow::fetched() {
    for (const int which : {0, 1}) {
        const int index = m_choice[static_cast<std::size_t>(which)]->currentIndex();
        NamedImage& image = *m_images[static_cast<std::size_t>(index)];
        if (image.file.image)
            continue;
        say(tr("Reading “%1”…").arg(image.title));
        image.fetch(
            [guard = QPointer<BlendWindow>(this), &image](const ExemplarFile& file) {
                if (!guard)
                    return;
                image.file = file;
                guard->changed();
            },
            [guard = QPointer<BlendWindow>(this)](const QString& why) {
                if (guard)
                    guard->say(why);
            });
        return false;
    }
    return true;
}

ValueEditor* BlendWindow::editorOf(std::string_view name) const {
    const auto row = std::find_if(m_rows.begin(), m_rows.end(),
                                  [&](const Row& known) { return known.param->name() == name; });
    return row == m_rows.end() ? nullptr : row->editor;
}

Values BlendWindow::settingsOf(const Cell& cell) const {
    Values values = cell.values;
    for (const Row& row : m_rows)
        values[row.param->name()] = row.editor->value();
    return m_tool->resolved(values);
}

void BlendWindow::arrange() {
    while (m_grid->count() > 0)
        delete m_grid->takeAt(0);
    std::vector<ImageViewer*> shown;
    for (const Cell& cell : m_cells) {
        cell.viewer->setVisible(cell.shown->isChecked());
        if (cell.shown->isChecked())
            shown.push_back(cell.viewer);
    }
    const int columns = shown.size() > 4 ? 3 : shown.size() > 1 ? 2 : 1;
    for (std::size_t i = 0; i < shown.size(); ++i)
        m_grid->addWidget(shown[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    // A parameter that matters to no picture shown is greyed.
    for (const Row& row : m_rows)
        row.editor->setEnabled(std::any_of(m_cells.begin(), m_cells.end(), [&](const Cell& cell) {
            return cell.shown->isChecked() && row.param->applies(settingsOf(cell));
        }));
    offerToSave();
}

void BlendWindow::showHandle() {
    if (m_tool->info().handle == ToolHandle::Curve)
        showCurve();
    else if (m_tool->info().handle == ToolHandle::Offset)
        showRegion();
}

void BlendWindow::showCurve() {
    const Values settings = settingsOf(m_cells.front());
    const std::vector<Choice>& shapes = m_tool->param("curve").choices();
    const auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const Choice& choice) {
        return choice.id == std::get<std::string>(settings.at("curve"));
    });
    for (const Cell& cell : m_cells) {
        auto* const viewer = qobject_cast<CurveViewer*>(cell.viewer);
        viewer->setCurve(static_cast<BlendCurve::Shape>(shape - shapes.begin()),
                         std::get<double>(settings.at("position")), std::get<int>(settings.at("band")));
        viewer->setCurveShown(m_showHandle->isChecked());
    }
}

void BlendWindow::limitRows(int shorterSide) {
    for (const Row& row : m_rows)
        row.editor->setLargest(row.param->largestFor(shorterSide));
    showHandle();
}

void BlendWindow::changed() {
    showHandle();
    m_use->hide();
    m_soon.start();
}

bool BlendWindow::twoChosen() {
    const NamedImage* const first = chosen(0);
    const NamedImage* const second = chosen(1);
    if (first == nullptr || second == nullptr) {
        say(tr("Open two images to blend."));
        return false;
    }
    // Within one image, only a region of it can be put elsewhere.
    if (first == second && !m_tool->info().region) {
        m_task.cancel();
        take({}, tr("Both images are “%1”. Open or choose another one to blend it with.").arg(first->title));
        return false;
    }
    return true;
}

void BlendWindow::blendNow() {
    if (!twoChosen() || !fetched())
        return;
    Shared first = chosen(0)->file.image, second = chosen(1)->file.image;
    const Size common{std::min(first->width(), second->width()), std::min(first->height(), second->height())};
    limitRows(common.shorterSide());
    if (m_tool->info().region)
        keepRegionOf(second);
    std::vector<std::pair<std::size_t, Values>> wanted;
    for (std::size_t i = 0; i < m_cells.size(); ++i)
        if (m_cells[i].shown->isChecked())
            wanted.emplace_back(i, settingsOf(m_cells[i]));
    if (wanted.empty()) {
        say(tr("Tick at least one way to show."));
        return;
    }
    QString note;
    const bool crops = m_tool->joinsSameSize() && first->size() != second->size();
    if (crops)
        note = tr("“%1” is %2 px, “%3” is %4 px: both are cropped to %5 px from the top left.")
                   .arg(chosen(0)->title, sizeText(first->size()), chosen(1)->title, sizeText(second->size()),
                        sizeText(common));
    const auto work = [tool = m_tool, first, second, crops, common, wanted,
                       region = m_tool->info().region ? m_region->mask : nullptr,
                       count = m_cells.size()](JobContext& context) {
        const JoinPictures joined{crops ? first->view().crop(0, 0, common) : first->view(),
                                  crops ? second->view().crop(0, 0, common) : second->view(), region.get()};
        Pictures pictures(count);
        std::uint32_t number = 0;
        for (const auto& [index, settings] : wanted) {
            context.step(number++, 1.0 / static_cast<double>(wanted.size()));
            pictures[index] = std::make_shared<const DisplayPicture>(
                std::make_shared<const Image>(tool->joined(joined, settings, context)));
        }
        return pictures;
    };
    m_task.start(
        {}, work, [this, note](const Pictures& pictures) { take(pictures, note); },
        [this](const QString& why) { take({}, why); });
    m_message->hide();
    m_bar->begin(tr("Blending…"), [this] { return m_task.progress(); });
}

/// @param pictures by way; none to clear them all.
void BlendWindow::take(const Pictures& pictures, const QString& note) {
    m_bar->end();
    const ImageViewer* reference = nullptr;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        ImageViewer* const viewer = m_cells[i].viewer;
        const std::shared_ptr<const DisplayPicture> picture = i < pictures.size() ? pictures[i] : nullptr;
        viewer->setPicture(picture);
        viewer->setBadge(m_cells[i].title);
        if (picture && reference == nullptr)
            reference = viewer;
        else if (picture)
            viewer->setView(reference->view(), reference->fitted());
    }
    offerToSave();
    say(note);
}

void BlendWindow::say(const QString& text) {
    m_message->setText(text);
    m_message->setVisible(!m_bar->isVisible());
}

QString BlendWindow::message() const {
    return m_message->text();
}

} // namespace texloom::ui
