#include "ui/plots/stress_dialog.h"

#include "ui/common/background.h"
#include "ui/common/screen_size.h"
#include "ui/jobs/task_bar.h"
#include "ui/plots/plot.h"
#include "ui/viewers/image_viewer.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include <iterator>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kWidth = 110, kLines = 46; ///< of the dialog, in widths and lines of text
constexpr int kPictureLines = 18;
constexpr int kFirstRounds = 5, kMostRounds = 50;

} // namespace

StressDialog::StressDialog(RunInput input, QWidget* parent)
    : QDialog(parent), m_first(std::move(input)), m_count(new QSpinBox),
      m_start(new QPushButton(tr("&Start"))), m_scroll(new QScrollArea), m_plot(new Plot),
      m_message(new QLabel), m_bar(new TaskBar) {
    setObjectName(QStringLiteral("stressDialog"));
    setWindowTitle(tr("Stress test"));
    m_count->setObjectName(QStringLiteral("stressRounds"));
    m_count->setRange(2, kMostRounds);
    m_count->setValue(kFirstRounds);
    m_start->setObjectName(QStringLiteral("stressStart"));
    m_start->setDefault(true);
    m_scroll->setWidgetResizable(true);
    m_scroll->setAccessibleName(tr("Rounds"));
    m_scroll->setFixedHeight(fontMetrics().height() * kPictureLines);
    m_message->setWordWrap(true);
    m_message->setText(tr("Makes %1 again and again, each time from the texture made before. What a method "
                          "loses or repeats adds up from round to round.")
                           .arg(QString::fromStdString(m_first.exemplars.front().image.name())));

    auto* form = new QFormLayout;
    form->addRow(tr("&Rounds"), m_count);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_start, QDialogButtonBox::ActionRole);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_message);
    column->addLayout(form);
    column->addWidget(m_scroll);
    column->addWidget(m_plot, 1);
    column->addWidget(m_bar);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_start, &QPushButton::clicked, this, &StressDialog::start);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_task.cancel();
        stop(tr("Stopped; the rounds made so far stay."));
    });
    showDistances();
    resizeWithinScreen(this, {fontMetrics().averageCharWidth() * kWidth, fontMetrics().height() * kLines});
}

QString StressDialog::message() const {
    return m_message->text();
}

void StressDialog::start() {
    m_input = m_first;
    m_distances.clear();
    auto* row = new QWidget;
    m_row = new QHBoxLayout(row);
    m_scroll->setWidget(row);
    m_start->setEnabled(false);
    showDistances();
    next();
}

void StressDialog::next() {
    const int number = static_cast<int>(m_distances.size()) + 1;
    m_task.start(
        {m_input.seed, m_input.threads, false},
        [input = m_input, first = m_first.exemplars](JobContext& context) {
            return stressRound(planRun(input), first, context);
        },
        [this](const StressRound& round) { take(round); }, [this](const QString& why) { stop(why); });
    m_bar->begin(tr("Round %1 of %2…").arg(number).arg(m_count->value()),
                 [this] { return m_task.progress(); });
}

void StressDialog::take(const StressRound& round) {
    m_distances.push_back(round.distance);
    learnFrom(round.result.synthesis.image, m_input);
    auto* viewer = new ImageViewer;
    const QString title = tr("Round %1").arg(m_distances.size());
    viewer->setAccessibleName(title);
    viewer->setBadge(title);
    viewer->setMinimumWidth(fontMetrics().height() * kPictureLines * 2 / 3);
    m_row->addWidget(viewer);
    inBackground(
        viewer,
        [image = m_input.exemplars.front().image.image] {
            return std::make_shared<const DisplayPicture>(image);
        },
        [viewer](std::shared_ptr<const DisplayPicture> picture) { viewer->setPicture(std::move(picture)); },
        [](const QString&) {});
    showDistances();
    if (static_cast<int>(m_distances.size()) < m_count->value())
        return next();
    stop({});
}

void StressDialog::stop(const QString& why) {
    m_bar->end();
    m_start->setEnabled(true);
    if (!why.isEmpty())
        m_message->setText(why);
}

void StressDialog::showDistances() {
    PlotData plotted{
        tr("How far each round is from the exemplar"), tr("round"), tr("distance"), {}, false, true};
    // In short, and in the order of distanceFigures(): a legend has little room.
    const QString names[] = {tr("colours"),        tr("patches, axis 1"),     tr("patches, axis 2"),
                             tr("patches, whole"), tr("patches, half scale"), tr("patches, quarter scale")};
    for (std::size_t i = 0; i < std::size(names) && !m_distances.empty(); ++i) {
        PlotSeries series{names[i], {}};
        for (std::size_t round = 0; round < m_distances.size(); ++round)
            series.points.emplace_back(static_cast<double>(round + 1),
                                       distanceFigures(m_distances[round])[i].value);
        plotted.series.push_back(std::move(series));
    }
    m_plot->setData(plotted);
}

} // namespace texloom::ui
