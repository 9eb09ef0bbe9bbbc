#include "ui/plots/figures_panel.h"

#include "core/analysis/correlation.h"
#include "core/analysis/histograms.h"
#include "core/analysis/lattice_detector.h"
#include "core/analysis/map_usage.h"
#include "core/base/text.h"
#include "core/io/model_file.h"
#include "core/job/memory.h"
#include "core/volume/mesh.h"
#include "ui/common/text.h"
#include "ui/jobs/task_bar.h"
#include "ui/runs/run_pictures.h"
#include "ui/viewers/image_viewer.h"

#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kBins = 64;
/// A curve that grows is drawn several times a second.
constexpr std::size_t kMostLivePoints = 500;
/// Larger pictures are not correlated with themselves by the way: it takes seconds, and much memory.
constexpr std::int64_t kMostCorrelated = 1 << 20;

QString channelName(int channel, int channels) {
    if (channels == 1)
        return FiguresPanel::tr("Values");
    switch (channel) {
    case 0:
        return FiguresPanel::tr("Red");
    case 1:
        return FiguresPanel::tr("Green");
    case 2:
        return FiguresPanel::tr("Blue");
    default:
        return FiguresPanel::tr("Channel %1").arg(channel + 1);
    }
}

/// Exemplar, result and their difference over one axis.
PlotData plotOf(const QString& title, const QString& xTitle, const HistogramPair& pair) {
    PlotSeries exemplar{FiguresPanel::tr("exemplar"), {}}, result{FiguresPanel::tr("result"), {}},
        difference{FiguresPanel::tr("difference"), {}};
    for (std::size_t i = 0; i < pair.exemplar.size(); ++i) {
        const double x = pair.low + (static_cast<double>(i) + 0.5) * pair.binWidth();
        exemplar.points.emplace_back(x, 100 * pair.exemplar[i]);
        result.points.emplace_back(x, 100 * pair.result[i]);
        difference.points.emplace_back(x, 100 * (pair.result[i] - pair.exemplar[i]));
    }
    return {FiguresPanel::tr("%1: %2 % in other bins").arg(title).arg(100 * pair.distance(), 0, 'f', 1),
            xTitle,
            FiguresPanel::tr("share, %"),
            {exemplar, result, difference}};
}

/// @param most points drawn: of a longer curve every so many-th, and the last.
PlotData plotOf(const Curve& curve, std::size_t most) {
    const QString name = translated(curve.name);
    PlotSeries series{name, {}};
    const std::size_t count = curve.values.size(), step = (count + most - 1) / most;
    for (std::size_t i = 0; i < count; i += step)
        series.points.emplace_back(static_cast<double>(i) + 1, curve.values[i]);
    if (count > 0 && (count - 1) % step != 0)
        series.points.emplace_back(static_cast<double>(count), curve.values.back());
    return {name, FiguresPanel::tr("step"), name, {series}};
}

/// γ around its middle, from black at 0 to white.
std::shared_ptr<const DisplayPicture> correlationOf(const ImageView& image, JobContext& context) {
    Image picture = autocorrelation(image, [&] { context.check(); }).picture();
    const PlaneSpan plane = picture.plane(0);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            plane(x, y) = std::max(0.0F, plane(x, y));
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(picture)));
}

} // namespace

FiguresPanel::FiguresPanel(QWidget* parent)
    : QWidget(parent), m_list(new QListWidget), m_stack(new QStackedWidget), m_hint(new QLabel),
      m_plot(new Plot), m_viewer(new ImageViewer), m_table(new QTableWidget(0, 2)), m_bar(new TaskBar) {
    setObjectName(QStringLiteral("figuresPanel"));
    m_list->setObjectName(QStringLiteral("figureList"));
    m_list->setAccessibleName(tr("Figures"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setText(tr("Make a result to see its figures."));
    m_viewer->setAccessibleName(tr("Picture"));
    m_table->setAccessibleName(tr("Numbers"));
    m_table->setHorizontalHeaderLabels({tr("Figure"), tr("Value")});
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    for (QWidget* page : {static_cast<QWidget*>(m_hint), static_cast<QWidget*>(m_plot),
                          static_cast<QWidget*>(m_viewer), static_cast<QWidget*>(m_table)})
        m_stack->addWidget(page);
    auto* split = new QSplitter(Qt::Horizontal);
    split->addWidget(m_list);
    split->addWidget(m_stack);
    split->setStretchFactor(1, 1);
    split->setSizes({fontMetrics().averageCharWidth() * 32, fontMetrics().averageCharWidth() * 100});
    auto* column = new QVBoxLayout(this);
    column->addWidget(split, 1);
    column->addWidget(m_bar);
    connect(m_list, &QListWidget::currentRowChanged, this, &FiguresPanel::showEntry);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_task.cancel();
        m_bar->end();
        m_hint->setText(tr("Stopped. Make another result, or close and open this dock to start again."));
    });
}

void FiguresPanel::setResult(std::shared_ptr<const Result> result) {
    m_result = std::move(result);
    m_curves.clear();
    if (!m_result) {
        m_task.cancel();
        m_made.reset();
        m_hint->setText(tr("Make a result to see its figures."));
        take({});
    }
    begin();
}

void FiguresPanel::showCurves(const std::vector<Curve>& curves) {
    m_curves = curves;
    m_result.reset();
    m_made.reset();
    m_task.cancel();
    begin();
}

void FiguresPanel::setSeen(bool seen) {
    m_seen = seen;
    begin();
}

void FiguresPanel::drawCurves() {
    std::vector<Entry> entries;
    for (const Curve& curve : m_curves)
        entries.push_back({translated(curve.name), plotOf(curve, kMostLivePoints)});
    take(std::move(entries));
}

void FiguresPanel::begin() {
    if (m_seen && !m_curves.empty())
        drawCurves();
    if (!m_seen || !m_result || m_made == m_result)
        return;
    m_task.start(
        {}, [result = m_result](JobContext& context) { return entriesOf(*result, context); },
        [this, result = m_result](std::vector<Entry> entries) {
            m_made = result;
            take(std::move(entries));
        },
        [this](const QString& why) {
            m_bar->end();
            m_hint->setText(why);
            m_stack->setCurrentWidget(m_hint);
        });
    m_bar->begin(tr("Looking at the result…"), [this] { return m_task.progress(); });
}

std::vector<FiguresPanel::Entry> FiguresPanel::entriesOf(const Result& result, JobContext& context) {
    std::vector<Entry> entries;
    std::vector<Number> numbers;
    for (const Figure& figure : result.figures)
        numbers.push_back({translated(figure.name), QString::number(figure.value, 'g', 5)});
    if (!numbers.empty())
        entries.push_back({tr("Numbers"), std::move(numbers)});
    for (const Curve& curve : result.synthesis.curves)
        entries.push_back(
            {translated(curve.name), plotOf(curve, std::max<std::size_t>(1, curve.values.size()))});
    if (knowsExemplars(result)) {
        addHistograms(result, entries, context);
        addCorrelations(result, entries, context);
    }
    addUse(result, entries, context);
    for (const Picture& picture : result.synthesis.pictures)
        entries.push_back({translated(picture.name), std::make_shared<const DisplayPicture>(
                                                         std::make_shared<const Image>(picture.image))});
    addOutputs(result, entries);
    return entries;
}

std::vector<FiguresPanel::Number> FiguresPanel::numbersOf(const Model& model) {
    std::size_t values = 0;
    for (const auto& [name, array] : model.arrays)
        values += std::visit([](const auto& held) { return held.size(); }, array.values);
    return {{tr("Kind"), QString::fromStdString(model.kind)},
            {tr("Arrays"), QString::number(model.arrays.size())},
            {tr("Values"), QString::number(values)}};
}

void FiguresPanel::addOutputs(const Result& result, std::vector<Entry>& entries) {
    for (const Port& port : result.plan.lastMethod().info().gives) {
        const std::vector<Asset>& assets = result.synthesis.outputs.at(port.id);
        if (assets.size() != 1) // sets, such as tiles, have a picture that shows them together
            continue;
        const QString title = translated(port.title);
        if (const auto* image = std::get_if<std::shared_ptr<const Image>>(&assets.front()))
            entries.push_back({title, std::make_shared<const DisplayPicture>(*image)});
        else if (const auto* model = std::get_if<std::shared_ptr<const Model>>(&assets.front()))
            entries.push_back({title, numbersOf(**model)});
        else if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&assets.front()))
            entries.push_back(
                {title, std::vector<Number>{{tr("Vertices"), QString::number((*mesh)->positions.size())},
                                            {tr("Triangles"), QString::number((*mesh)->triangles.size())}}});
    }
}

void FiguresPanel::addUse(const Result& result, std::vector<Entry>& entries, JobContext& context) {
    const PositionMap& map = result.synthesis.map;
    if (result.synthesis.mapKind == MapKind::None || map.size().empty())
        return;
    const std::size_t count = map.exemplarSizes().size();
    for (std::size_t e = 0; e < count; ++e) {
        Image used = occurrencePicture(occurrence(map, static_cast<int>(e), [&] { context.check(); }));
        const QString name = QString::fromStdString(result.plan.request.exemplars[e].name);
        entries.push_back(
            {count == 1 ? tr("How often pixels are used") : tr("How often pixels are used: %1").arg(name),
             std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(used)))});
    }
}

void FiguresPanel::addHistograms(const Result& result, std::vector<Entry>& entries, JobContext& context) {
    const Image& image = result.synthesis.image;
    std::vector<ImageView> exemplars;
    for (const Exemplar& exemplar : result.plan.request.exemplars)
        exemplars.push_back(exemplar.image->view().channelRange(0, image.channels()));
    context.stage(0.3, TR("Comparing colours"));
    const auto colors = colorHistograms(image, exemplars, kBins, context);
    for (std::size_t c = 0; c < colors.size(); ++c) {
        const QString name =
            tr("Colours: %1").arg(channelName(static_cast<int>(c), image.channels()).toLower());
        entries.push_back({name, plotOf(name, tr("value"), colors[c])});
    }
    context.stage(0.3, TR("Comparing patches"));
    const auto components = componentHistograms(image, exemplars, kBins, context);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const QString name = i == 0 ? tr("Patches: first component") : tr("Patches: second component");
        entries.push_back({name, plotOf(name, tr("place along the principal axis"), components[i])});
    }
}

void FiguresPanel::addCorrelations(const Result& result, std::vector<Entry>& entries, JobContext& context) {
    context.stage(0.4, TR("Comparing with itself"));
    const Image& exemplar = *result.plan.request.exemplars.front().image;
    const auto add = [&](const QString& title, const ImageView& image) {
        if (image.size().area() <= kMostCorrelated &&
            latticeBytesFor(image.size(), image.channels) < availableMemory())
            entries.push_back({title, correlationOf(image, context)});
    };
    add(tr("Autocorrelation: exemplar"), exemplar.view().channelRange(0, result.synthesis.image.channels()));
    context.progress(0.5);
    add(tr("Autocorrelation: result"), result.synthesis.image);
}

void FiguresPanel::take(std::vector<Entry> entries) {
    m_bar->end();
    const QString before = m_list->currentItem() != nullptr ? m_list->currentItem()->text() : QString();
    const QStringList listed = titles();
    m_entries = std::move(entries);
    if (!listed.isEmpty() && titles() == listed) // leaves the place in the list as it is
        return showEntry(m_list->currentRow());
    m_list->clear();
    m_list->addItems(titles());
    const qsizetype kept = titles().indexOf(before);
    m_list->setCurrentRow(std::max(0, static_cast<int>(kept)));
}

QStringList FiguresPanel::titles() const {
    QStringList titles;
    for (const Entry& entry : m_entries)
        titles += entry.title;
    return titles;
}

void FiguresPanel::showFigure(const QString& title) {
    m_list->setCurrentRow(static_cast<int>(titles().indexOf(title)));
}

void FiguresPanel::showEntry(int row) {
    if (row < 0 || row >= static_cast<int>(m_entries.size())) {
        m_stack->setCurrentWidget(m_hint);
        return;
    }
    const Entry& entry = m_entries[static_cast<std::size_t>(row)];
    if (const auto* plotted = std::get_if<PlotData>(&entry.content)) {
        m_plot->setData(*plotted);
        m_stack->setCurrentWidget(m_plot);
    } else if (const auto* picture = std::get_if<std::shared_ptr<const DisplayPicture>>(&entry.content)) {
        m_viewer->setPicture(*picture);
        m_viewer->setAccessibleName(entry.title);
        m_stack->setCurrentWidget(m_viewer);
    } else {
        const auto& numbers = std::get<std::vector<Number>>(entry.content);
        m_table->setRowCount(static_cast<int>(numbers.size()));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            m_table->setItem(static_cast<int>(i), 0, new QTableWidgetItem(numbers[i].name));
            m_table->setItem(static_cast<int>(i), 1, new QTableWidgetItem(numbers[i].value));
        }
        m_stack->setCurrentWidget(m_table);
    }
}

} // namespace texloom::ui
