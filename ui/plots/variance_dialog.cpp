#include "ui/plots/variance_dialog.h"

#include "core/base/text.h"
#include "ui/common/screen_size.h"
#include "ui/common/text.h"
#include "ui/jobs/task_bar.h"
#include "ui/plots/plot.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kVarianceWidth = 90, kVarianceLines = 36; ///< of the dialog, in widths and lines of text
constexpr int kSmallest = 2, kLargestPatch = 512, kMostNeighbours = 100'000, kMostPatches = 10'000;
constexpr int kFirstPatches = 16;

/// "10, 20, 40" as numbers in range, rising; none if it is anything else.
std::optional<std::vector<int>> numbersOf(const QString& text, int largest) {
    std::vector<int> numbers;
    for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        bool whole = false;
        const int number = part.trimmed().toInt(&whole);
        if (!whole || number < kSmallest || number > largest)
            return {};
        numbers.push_back(number);
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers.empty() ? std::nullopt : std::optional(numbers);
}

} // namespace

VarianceDialog::VarianceDialog(std::vector<NamedImage> images, QWidget* parent)
    : QDialog(parent), m_images(std::move(images)), m_image(new QComboBox),
      m_sizes(new QLineEdit(QStringLiteral("10, 20, 40, 80"))),
      m_neighbours(new QLineEdit(QStringLiteral("5, 10, 30, 50, 500, 1000"))), m_patches(new QSpinBox),
      m_compute(new QPushButton(tr("&Compute"))), m_plot(new Plot), m_message(new QLabel),
      m_bar(new TaskBar) {
    setObjectName(QStringLiteral("varianceDialog"));
    setWindowTitle(tr("Patch variance"));
    for (const NamedImage& image : m_images)
        m_image->addItem(image.title);
    m_sizes->setObjectName(QStringLiteral("varianceSizes"));
    m_sizes->setToolTip(tr("Sides of the patches in pixels, %1 to %2, with commas between")
                            .arg(kSmallest)
                            .arg(kLargestPatch));
    m_neighbours->setObjectName(QStringLiteral("varianceNeighbours"));
    m_neighbours->setToolTip(tr("How many of the patches most like one, %1 to %2, with commas between")
                                 .arg(kSmallest)
                                 .arg(kMostNeighbours));
    m_patches->setRange(1, kMostPatches);
    m_patches->setValue(kFirstPatches);
    m_patches->setToolTip(tr("How many patches to take the mean over: more is surer and slower."));
    m_compute->setObjectName(QStringLiteral("varianceCompute"));
    m_message->setWordWrap(true);

    auto* form = new QFormLayout;
    form->addRow(tr("&Image"), m_image);
    form->addRow(tr("Patch &sizes n"), m_sizes);
    form->addRow(tr("&Neighbours m"), m_neighbours);
    form->addRow(tr("&Patches"), m_patches);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_compute, QDialogButtonBox::ActionRole);
    m_compute->setDefault(true);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(m_plot, 1);
    column->addWidget(m_message);
    column->addWidget(m_bar);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_compute, &QPushButton::clicked, this, &VarianceDialog::compute);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_task.cancel();
        m_bar->end();
        m_compute->setEnabled(true);
    });
    m_plot->setData(
        {tr("Mean standard deviation of the m patches most like one"), tr("m"), tr("σ̄"), {}, true, true});
    say(tr(
        "Press Compute. Where σ̄ is small, m patches are alike and a Gaussian model of them copies; where it "
        "is large, the model blurs."));
    resizeWithinScreen(
        this, {fontMetrics().averageCharWidth() * kVarianceWidth, fontMetrics().height() * kVarianceLines});
}

void VarianceDialog::say(const QString& text) {
    m_message->setText(text);
    m_message->setVisible(!text.isEmpty());
}

QString VarianceDialog::message() const {
    return m_message->text();
}

void VarianceDialog::compute() {
    const auto sizes = numbersOf(m_sizes->text(), kLargestPatch);
    const auto neighbours = numbersOf(m_neighbours->text(), kMostNeighbours);
    const ExemplarFile& file = m_images[static_cast<std::size_t>(m_image->currentIndex())].file;
    const int side = file.image->size().shorterSide();
    if (!sizes)
        return say(tr("Give patch sizes from %1 to %2 px with commas between, such as 10, 20, 40.")
                       .arg(kSmallest)
                       .arg(kLargestPatch));
    if (!neighbours)
        return say(tr("Give numbers of neighbours from %1 to %2 with commas between, such as 5, 10, 30.")
                       .arg(kSmallest)
                       .arg(kMostNeighbours));
    if (sizes->front() > side)
        return say(tr("The smallest patch of %1 px does not fit into %2 with a shorter side of %3 px.")
                       .arg(sizes->front())
                       .arg(QString::fromStdString(file.name()))
                       .arg(side));
    say({});
    m_compute->setEnabled(false);
    m_task.start(
        {},
        [image = file.image, sizes = *sizes, neighbours = *neighbours,
         patches = m_patches->value()](JobContext& context) {
            context.stage(1, TR("Comparing patches"));
            return patchVariance(*image, sizes, neighbours, patches, context);
        },
        [this](const PatchVariance& variance) { showVariance(variance); },
        [this](const QString& why) {
            m_bar->end();
            m_compute->setEnabled(true);
            say(why);
        });
    m_bar->begin(tr("Comparing patches…"), [this] { return m_task.progress(); });
}

void VarianceDialog::showVariance(const PatchVariance& variance) {
    m_bar->end();
    m_compute->setEnabled(true);
    PlotData plotted = m_plot->data();
    plotted.series.clear();
    for (std::size_t i = 0; i < variance.sizes.size(); ++i) {
        PlotSeries series{tr("n = %1 px").arg(variance.sizes[i]), {}};
        for (std::size_t j = 0; j < variance.neighbours.size(); ++j)
            if (variance.deviations[i][j] >= 0)
                series.points.emplace_back(variance.neighbours[j], variance.deviations[i][j]);
        plotted.series.push_back(std::move(series));
    }
    m_plot->setData(plotted);
}

} // namespace texloom::ui
