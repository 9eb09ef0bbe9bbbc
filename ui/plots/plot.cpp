#include "ui/plots/plot.h"

#include "ui/common/appearance.h"

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QClipboard>
#include <QEvent>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLegend>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace texloom::ui {

namespace {

/// Colours that colour-blind people tell apart (Okabe & Ito 2008), for light and for dark windows.
QColor colorOf(std::size_t series, bool dark) {
    static const QRgb light[] = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x8a6d00, 0x3a3a3a};
    static const QRgb bright[] = {0x56b4e9, 0xe69f00, 0x2fd0a0, 0xe79fc7, 0xf0e442, 0xd0d0d0};
    constexpr std::size_t kColors = std::size(light);
    return QColor::fromRgb((dark ? bright : light)[series % kColors]);
}

Qt::PenStyle dashOf(std::size_t series) {
    static const Qt::PenStyle styles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine,
                                          Qt::DashDotDotLine};
    return styles[series % std::size(styles)];
}

QString numberOf(double value) {
    return QString::number(value, 'g', 6);
}

QString quoted(QString text) {
    return QLatin1Char('"') + text.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

struct Limits {
    double low = 0, high = 0;
};

/// The range of all points along one axis, never empty.
Limits limitsOf(const PlotData& data, bool x) {
    Limits limits{HUGE_VAL, -HUGE_VAL};
    for (const PlotSeries& series : data.series)
        for (const QPointF& point : series.points) {
            const double value = x ? point.x() : point.y();
            limits.low = std::min(limits.low, value);
            limits.high = std::max(limits.high, value);
        }
    if (limits.low > limits.high)
        return {0, 1};
    if (!x && limits.low > 0 && limits.low < 0.5 * limits.high)
        limits.low = 0;
    if (limits.high - limits.low < 1e-12 * std::max(1.0, std::abs(limits.high)))
        limits.high = limits.low + 1;
    return limits;
}

/// The whole powers of ten around a range, so that the axis has numbers.
Limits powersAround(const Limits& limits) {
    const double low = std::pow(10, std::floor(std::log10(std::max(1e-12, limits.low))));
    return {low, std::max(10 * low, std::pow(10, std::ceil(std::log10(std::max(1e-12, limits.high)))))};
}

/// Whether x counts something: rounds, iterations.
bool isCounted(const PlotData& data) {
    const auto isWhole = [](const QPointF& point) { return point.x() == std::floor(point.x()); };
    return std::all_of(data.series.begin(), data.series.end(), [&](const PlotSeries& series) {
        return std::all_of(series.points.begin(), series.points.end(), isWhole);
    });
}

/// Ticks at multiples of 1, 2, 5, 10, 20 and so on.
void tickWhole(QValueAxis& axis) {
    constexpr double kMostTicks = 8;
    double step = 1;
    for (int i = 0; (axis.max() - axis.min()) / step > kMostTicks; ++i)
        step *= i % 3 == 1 ? 2.5 : 2;
    axis.setLabelFormat(QStringLiteral("%d"));
    axis.setTickType(QValueAxis::TicksDynamic);
    axis.setTickInterval(step);
}

} // namespace

Plot::Plot(QWidget* parent)
    : QWidget(parent), m_stack(new QStackedWidget(this)), m_view(new QChartView(m_stack)),
      m_table(new QTableWidget(m_stack)), m_numbers(new QToolButton(this)), m_copy(new QToolButton(this)) {
    m_view->setRenderHint(QPainter::Antialiasing);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setFocusPolicy(Qt::NoFocus);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_stack->addWidget(m_view);
    m_stack->addWidget(m_table);
    m_numbers->setText(tr("Numbers"));
    m_numbers->setObjectName(QStringLiteral("plotNumbers"));
    m_numbers->setToolTip(tr("Show the numbers in a table in place of the plot"));
    m_numbers->setCheckable(true);
    m_copy->setText(tr("Copy as CSV"));
    m_copy->setObjectName(QStringLiteral("plotCopy"));
    m_copy->setToolTip(tr("Put the numbers on the clipboard, a line for each value of the horizontal axis"));
    for (QToolButton* button : {m_numbers, m_copy})
        button->setFocusPolicy(Qt::StrongFocus);
    auto* buttons = new QVBoxLayout;
    buttons->addWidget(m_numbers);
    buttons->addWidget(m_copy);
    buttons->addStretch();
    auto* row = new QHBoxLayout(this); // plots are wide and low
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_stack, 1);
    row->addLayout(buttons);
    connect(m_numbers, &QToolButton::toggled, this, &Plot::setNumbers);
    connect(m_copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(csv()); });
    draw();
}

void Plot::setData(const PlotData& data) {
    m_data = data;
    setAccessibleName(data.title);
    m_table->setAccessibleName(data.title);
    m_numbers->setEnabled(!data.empty());
    m_copy->setEnabled(!data.empty());
    draw();
    fillTable();
}

void Plot::setNumbers(bool numbers) {
    m_numbers->setChecked(numbers);
    m_stack->setCurrentWidget(numbers ? static_cast<QWidget*>(m_table) : m_view);
}

void Plot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        draw();
}

void Plot::draw() {
    auto chart = std::make_unique<QChart>();
    chart->setTitle(m_data.title);
    chart->setMargins({});
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    chart->setBackgroundRoundness(0);
    chart->legend()->setVisible(m_data.series.size() > 1);
    chart->legend()->setAlignment(Qt::AlignRight);
    chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    const Limits x = limitsOf(m_data, true), y = limitsOf(m_data, false);
    QAbstractAxis* across = nullptr;
    if (m_data.logarithmicX) {
        auto* axis = new QLogValueAxis;
        axis->setBase(10);
        axis->setLabelFormat(QStringLiteral("%g"));
        axis->setMinorTickCount(-1);
        across = axis;
    } else {
        across = new QValueAxis;
    }
    const Limits shown = m_data.logarithmicX ? powersAround(x) : x;
    across->setRange(shown.low, shown.high);
    across->setTitleText(m_data.xTitle);
    auto* up = new QValueAxis;
    up->setRange(y.low, y.high);
    up->setTitleText(m_data.yTitle);
    chart->addAxis(across, Qt::AlignBottom);
    chart->addAxis(up, Qt::AlignLeft);
    across->setVisible(!m_data.empty());
    up->setVisible(!m_data.empty());
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.75);
    for (std::size_t i = 0; i < m_data.series.size(); ++i) {
        auto* line = new QLineSeries;
        line->setName(m_data.series[i].name);
        line->setPen(QPen(colorOf(i, isDark(palette())), width, dashOf(i)));
        line->setPointsVisible(m_data.points);
        for (const QPointF& point : m_data.series[i].points)
            line->append(point);
        chart->addSeries(line);
        line->attachAxis(across);
        line->attachAxis(up);
    }
    up->applyNiceNumbers();
    if (auto* linear = qobject_cast<QValueAxis*>(across); linear && isCounted(m_data))
        tickWhole(*linear);
    else if (linear)
        linear->applyNiceNumbers();
    colorChart(chart.get());
    const std::unique_ptr<QChart> former(m_view->chart()); // setChart() still touches it
    m_view->setChart(chart.release());
}

void Plot::colorChart(QChart* chart) const {
    const QPalette& colors = palette();
    const QColor text = colors.color(QPalette::Text);
    chart->setBackgroundBrush(colors.color(QPalette::Base));
    chart->setTitleBrush(text);
    chart->setTitleFont(font());
    chart->legend()->setLabelColor(text);
    chart->legend()->setFont(font());
    QColor grid = text;
    grid.setAlphaF(0.2F);
    QColor faint = text;
    faint.setAlphaF(0.08F);
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.9);
    for (QAbstractAxis* axis : chart->axes()) {
        axis->setLabelsColor(text);
        axis->setTitleBrush(text);
        axis->setTitleFont(small);
        axis->setLabelsFont(small);
        axis->setLinePenColor(text);
        axis->setGridLineColor(grid);
        axis->setMinorGridLineColor(faint);
    }
}

std::vector<Plot::Row> Plot::rows() const {
    std::map<double, std::vector<QString>> byX;
    for (std::size_t i = 0; i < m_data.series.size(); ++i)
        for (const QPointF& point : m_data.series[i].points) {
            std::vector<QString>& values = byX[point.x()];
            values.resize(m_data.series.size());
            values[i] = numberOf(point.y());
        }
    std::vector<Row> all;
    for (auto& [x, values] : byX)
        all.push_back({x, std::move(values)});
    return all;
}

QString Plot::csv() const {
    QStringList head = {quoted(m_data.xTitle)};
    for (const PlotSeries& series : m_data.series)
        head += quoted(series.name);
    QString text = head.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (const Row& row : rows()) {
        QStringList line = {numberOf(row.x)};
        for (const QString& value : row.values)
            line += value;
        text += line.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

void Plot::fillTable() {
    const std::vector<Row> all = rows();
    m_table->clear();
    m_table->setColumnCount(static_cast<int>(m_data.series.size()) + 1);
    m_table->setRowCount(static_cast<int>(all.size()));
    QStringList head = {m_data.xTitle};
    for (const PlotSeries& series : m_data.series)
        head += series.name;
    m_table->setHorizontalHeaderLabels(head);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (std::size_t r = 0; r < all.size(); ++r) {
        m_table->setItem(static_cast<int>(r), 0, new QTableWidgetItem(numberOf(all[r].x)));
        for (std::size_t c = 0; c < all[r].values.size(); ++c)
            m_table->setItem(static_cast<int>(r), static_cast<int>(c) + 1,
                             new QTableWidgetItem(all[r].values[c]));
    }
}

} // namespace texloom::ui
