#include "ui/blend/blend_window.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/memory.h"
#include "core/session/export/export.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/jobs/task_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr std::chrono::milliseconds kPause{150};
constexpr int kWidth = 150, kLines = 44; ///< of the window, in widths and lines of text
constexpr int kPositionSteps = 1000;
constexpr int kLargestBand = 4096;
const QString kFolder = QStringLiteral("folders/blend");

QString titleOf(BlendWindow::Way way) {
    switch (way) {
    case BlendWindow::CutWay:
        return BlendWindow::tr("Minimum-error cut");
    case BlendWindow::PoissonWay:
        return BlendWindow::tr("Poisson editing");
    case BlendWindow::LinearWay:
        return BlendWindow::tr("Midway, linear");
    case BlendWindow::ProgressiveWay:
        return BlendWindow::tr("Midway, progressive");
    case BlendWindow::EdgeWay:
        break;
    }
    return BlendWindow::tr("Not blended");
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
    : QDialog(parent), m_shape(new QComboBox), m_position(new QDoubleSpinBox),
      m_slider(new QSlider(Qt::Horizontal)), m_band(new QSpinBox), m_color(new QComboBox),
      m_showCurve(new QCheckBox(tr("Show the cur&ve and its band"))), m_grid(new QGridLayout),
      m_message(new QLabel), m_bar(new TaskBar), m_save(new QPushButton(tr("&Save"))),
      m_use(new QPushButton(tr("Open as e&xemplar"))) {
    setObjectName(QStringLiteral("blendWindow"));
    setWindowTitle(tr("Blend two images"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kPause);
    connect(&m_soon, &QTimer::timeout, this, &BlendWindow::blendNow);
    makeCells();
    auto* content = new QHBoxLayout;
    content->addWidget(makeOptions());
    content->addLayout(m_grid, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(content, 1);
    column->addWidget(makeBottom());
    for (const NamedImage& image : images)
        addImage(image);
    if (images.size() > 1)
        m_choice[1]->setCurrentIndex(1);
    for (QComboBox* choice : m_choice)
        connect(choice, &QComboBox::currentIndexChanged, this, &BlendWindow::changed);
    resize(fontMetrics().averageCharWidth() * kWidth, fontMetrics().height() * kLines);
    arrange();
    changed();
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
    m_shape->setObjectName(QStringLiteral("blendShape"));
    m_shape->addItems({tr("Horizontal"), tr("Vertical"), tr("Circular")});
    m_shape->setToolTip(tr("The first image lies above, left of or outside the curve; circles go around the "
                           "bottom right corner."));
    form->addRow(tr("&Curve"), m_shape);
    form->addRow(tr("&Position"), makePositionRow());
    qobject_cast<QLabel*>(form->labelForField(m_position->parentWidget()))->setBuddy(m_position);
    m_band->setObjectName(QStringLiteral("blendBand"));
    m_band->setRange(2, kLargestBand);
    m_band->setValue(BlendOptions{}.band);
    m_band->setSuffix(tr(" px"));
    m_band->setToolTip(tr("How far from the curve, on either side, pixels may change: up to half the images' "
                          "shorter side."));
    form->addRow(tr("&Band"), m_band);
    m_color->setObjectName(QStringLiteral("blendColor"));
    m_color->addItem(tr("As they are (RGB)"), static_cast<int>(BlendColor::Rgb));
    m_color->addItem(tr("Cosine axes (DCT)"), static_cast<int>(BlendColor::Dct));
    m_color->addItem(tr("Principal axes (PCA)"), static_cast<int>(BlendColor::Pca));
    m_color->setCurrentIndex(1);
    m_color->setToolTip(tr("The colour axes that midway blending treats one by one."));
    form->addRow(tr("Co&lours"), m_color);
    auto* shown = new QVBoxLayout;
    for (const Cell& cell : m_cells)
        shown->addWidget(cell.shown);
    form->addRow(tr("Show"), shown);
    m_showCurve->setChecked(true);
    form->addRow(QString(), m_showCurve);
    connect(m_shape, &QComboBox::currentIndexChanged, this, &BlendWindow::changed);
    connect(m_band, &QSpinBox::valueChanged, this, &BlendWindow::changed);
    connect(m_color, &QComboBox::currentIndexChanged, this, &BlendWindow::changed);
    connect(m_showCurve, &QCheckBox::toggled, this, [this](bool on) {
        for (const Cell& cell : m_cells)
            cell.viewer->setCurveShown(on);
    });
    return options;
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

QWidget* BlendWindow::makePositionRow() {
    auto* row = new QWidget;
    m_position->setObjectName(QStringLiteral("blendPosition"));
    m_position->setAccessibleName(tr("Position of the curve"));
    m_position->setRange(0, 100);
    m_position->setDecimals(1);
    m_position->setValue(50);
    m_position->setSuffix(tr(" %"));
    m_slider->setRange(0, kPositionSteps);
    m_slider->setValue(kPositionSteps / 2);
    m_slider->setAccessibleName(tr("Position of the curve"));
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_position);
    connect(m_slider, &QSlider::valueChanged, this,
            [this](int at) { m_position->setValue(100.0 * at / kPositionSteps); });
    connect(m_position, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
        const QSignalBlocker blocker(m_slider);
        m_slider->setValue(static_cast<int>(std::lround(percent * kPositionSteps / 100)));
        changed();
    });
    return row;
}

void BlendWindow::makeCells() {
    const std::array<std::pair<BlendMethod, Propagation>, kWays> ways = {
        {{BlendMethod::Cut, Propagation::Linear},
         {BlendMethod::Poisson, Propagation::Linear},
         {BlendMethod::Midway, Propagation::Linear},
         {BlendMethod::Midway, Propagation::Progressive},
         {BlendMethod::Edge, Propagation::Linear}}};
    for (std::size_t i = 0; i < kWays; ++i) {
        const QString title = titleOf(static_cast<Way>(i));
        auto* viewer = new CurveViewer(this);
        viewer->setAccessibleName(title);
        viewer->setPlaceholder(tr("Choose two images of one size."));
        auto* shown = new QCheckBox(title, this);
        shown->setObjectName(QStringLiteral("blendWay%1").arg(i));
        shown->setChecked(i != EdgeWay);
        m_cells[i] = {ways[i].first, ways[i].second, viewer, shown};
        connect(shown, &QCheckBox::toggled, this, [this] {
            arrange();
            changed();
        });
        connect(viewer, &CurveViewer::positionDragged, this,
                [this](double position) { m_position->setValue(100 * position); });
    }
    for (const Cell& from : m_cells)
        for (const Cell& to : m_cells)
            if (from.viewer != to.viewer)
                share(from.viewer, to.viewer);
}

QWidget* BlendWindow::makeBottom() {
    m_message->setObjectName(QStringLiteral("blendMessage"));
    m_message->setWordWrap(true);
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_save->setObjectName(QStringLiteral("blendSave"));
    auto* menu = new QMenu(m_save);
    for (std::size_t i = 0; i < kWays; ++i) {
        const Way way = static_cast<Way>(i);
        QAction* const action =
            menu->addAction(tr("%1…").arg(titleOf(way)), this, [this, way] { saveAs(way); });
        connect(menu, &QMenu::aboutToShow, action, [this, action, way] {
            action->setVisible(m_cells[way].shown->isChecked());
            action->setEnabled(viewer(way)->picture() != nullptr);
        });
    }
    m_save->setMenu(menu);
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
    const QString path = QFileDialog::getOpenFileName(this, tr("Open an image"),
                                                      QSettings().value(kFolder).toString(), pictureFilter());
    if (path.isEmpty())
        return;
    QSettings().setValue(kFolder, QFileInfo(path).path());
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

BlendOptions BlendWindow::optionsOf(const Cell& cell) const {
    BlendOptions options;
    options.method = cell.method;
    options.band = m_band->value();
    options.midway.propagation = cell.propagation;
    options.midway.color = static_cast<BlendColor>(m_color->currentData().toInt());
    return options;
}

void BlendWindow::arrange() {
    while (m_grid->count() > 0)
        delete m_grid->takeAt(0);
    std::vector<CurveViewer*> shown;
    for (const Cell& cell : m_cells) {
        cell.viewer->setVisible(cell.shown->isChecked());
        if (cell.shown->isChecked())
            shown.push_back(cell.viewer);
    }
    const int columns = shown.size() > 4 ? 3 : shown.size() > 1 ? 2 : 1;
    for (std::size_t i = 0; i < shown.size(); ++i)
        m_grid->addWidget(shown[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    const bool midway = m_cells[LinearWay].shown->isChecked() || m_cells[ProgressiveWay].shown->isChecked();
    m_color->setEnabled(midway);
    offerToSave();
}

void BlendWindow::showCurve() {
    const auto shape = static_cast<BlendCurve::Shape>(m_shape->currentIndex());
    for (const Cell& cell : m_cells)
        cell.viewer->setCurve(shape, m_position->value() / 100, m_band->value());
}

void BlendWindow::limitBand(int shorterSide) {
    const QSignalBlocker blocker(m_band);
    m_band->setMaximum(std::max(m_band->minimum(), shorterSide / 2));
    showCurve();
}

void BlendWindow::changed() {
    showCurve();
    m_use->hide();
    m_soon.start();
}

void BlendWindow::blendNow() {
    const NamedImage* const first = chosen(0);
    const NamedImage* const second = chosen(1);
    if (first == nullptr || second == nullptr) {
        say(tr("Open two images of one size to blend."));
        return;
    }
    if (first == second) {
        m_task.cancel();
        take({});
        say(tr("Both images are “%1”. Open or choose another one of its size to blend it with.")
                .arg(first->title));
        return;
    }
    if (!fetched())
        return;
    limitBand(std::min(first->file.image->size().shorterSide(), second->file.image->size().shorterSide()));
    std::vector<std::pair<std::size_t, BlendOptions>> wanted;
    for (std::size_t i = 0; i < kWays; ++i)
        if (m_cells[i].shown->isChecked())
            wanted.emplace_back(i, optionsOf(m_cells[i]));
    if (wanted.empty()) {
        say(tr("Tick at least one way to show."));
        return;
    }
    const auto shape = static_cast<BlendCurve::Shape>(m_shape->currentIndex());
    const auto work = [a = first->file.image, b = second->file.image, shape, wanted,
                       position = m_position->value() / 100](JobContext& context) {
        Pictures pictures;
        std::uint32_t number = 0;
        for (const auto& [index, options] : wanted) {
            context.step(number++, 1.0 / static_cast<double>(wanted.size()));
            const std::uint64_t bytes = blendBytesFor(a->size(), a->channels(), options);
            if (const std::uint64_t free = availableMemory(); bytes > free)
                fail("Blending takes {}, of which only {} are free; use smaller images.", byteText(bytes),
                     byteText(free));
            auto made = std::make_shared<const Image>(
                blend(*a, *b, BlendCurve::at(shape, position, a->size()), options, context));
            pictures[index] = std::make_shared<const DisplayPicture>(std::move(made));
        }
        return pictures;
    };
    m_task.start(
        {}, work, [this](const Pictures& pictures) { take(pictures); },
        [this](const QString& why) {
            take({});
            say(why);
        });
    m_message->hide();
    m_bar->begin(tr("Blending…"), [this] { return m_task.progress(); });
}

void BlendWindow::take(const Pictures& pictures) {
    m_bar->end();
    say({});
    const CurveViewer* reference = nullptr;
    for (std::size_t i = 0; i < kWays; ++i) {
        CurveViewer* const viewer = m_cells[i].viewer;
        viewer->setPicture(pictures[i]);
        viewer->setBadge(titleOf(static_cast<Way>(i)));
        if (pictures[i] && reference == nullptr)
            reference = viewer;
        else if (pictures[i])
            viewer->setView(reference->view(), reference->fitted());
    }
    offerToSave();
}

void BlendWindow::offerToSave() {
    m_save->setEnabled(std::any_of(m_cells.begin(), m_cells.end(), [](const Cell& cell) {
        return cell.shown->isChecked() && cell.viewer->picture() != nullptr;
    }));
}

void BlendWindow::say(const QString& text) {
    m_message->setText(text);
    m_message->setVisible(!m_bar->isVisible());
}

QString BlendWindow::message() const {
    return m_message->text();
}

void BlendWindow::saveAs(Way way) {
    const NamedImage* const first = chosen(0);
    const NamedImage* const second = chosen(1);
    const QString name = tr("%1 and %2.png").arg(first->title, second->title);
    const QString folder = QSettings().value(kFolder).toString();
    const QString path = QFileDialog::getSaveFileName(this, tr("Save the blend"), QDir(folder).filePath(name),
                                                      tr("Pictures (*.png *.jpg *.tif *.exr *.hdr)"));
    if (path.isEmpty())
        return;
    QSettings().setValue(kFolder, QFileInfo(path).path());
    save(way, path);
}

void BlendWindow::save(Way way, const QString& path) {
    const NamedImage* const first = chosen(0);
    const std::shared_ptr<const DisplayPicture> picture = viewer(way)->picture();
    if (first == nullptr || !picture)
        return;
    m_writing.start(
        {},
        [picture, path, like = first->file](JobContext& context) {
            exportPicture(toPath(path), picture->values(), like, [&] { context.check(); });
            return path;
        },
        [this](const QString& written) {
            m_written = written;
            m_use->show();
            say(tr("Wrote %1.").arg(written));
        },
        [this](const QString& why) { say(why); });
}

} // namespace texloom::ui
