#include "ui/lattice/lattice_tool.h"

#include "core/analysis/lattice_settings.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "ui/inspector/inspector.h"
#include "ui/jobs/task_bar.h"
#include "ui/lattice/lattice_values.h"
#include "ui/window/text.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

/// The method that uses a lattice when the one chosen does not.
const QString kMethod = QStringLiteral("near-regular");
/// An exemplar whose lattice takes longer than this, in seconds, is looked at only when asked.
constexpr double kAtOnce = 4;
/// Vectors this near to each other, in pixels, are the same.
constexpr double kSame = 0.05;
constexpr int kTableRows = 5;
constexpr double kLargest = 65535;

/// γ as a picture, white at the highest of the maxima that can be vectors and black where it is 0.
std::shared_ptr<const DisplayPicture> pictureOf(const Correlation& correlation) {
    if (correlation.size().empty())
        return nullptr;
    constexpr int kMiddle = 4; // γ is 1 here, whatever the texture
    float highest = 0.05F;
    for (int dy = 0; dy <= correlation.bottom() / 2; ++dy)
        for (int dx = -correlation.left() / 2; dx <= correlation.right() / 2; ++dx)
            if (dx * dx + dy * dy > kMiddle * kMiddle)
                highest = std::max(highest, correlation.at(dx, dy));
    Image picture = correlation.picture();
    const PlaneSpan plane = picture.plane(0);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            plane(x, y) = std::clamp(plane(x, y) / highest, 0.0F, 1.0F);
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(picture)));
}

/// "120.25, 0.10".
QString vectorText(Vec2 vector, int decimals = 2) {
    return QStringLiteral("%1, %2").arg(vector.x, 0, 'f', decimals).arg(vector.y, 0, 'f', decimals);
}

bool same(const Lattice& a, const Lattice& b) {
    return (a.v1 - b.v1).length() < kSame && (a.v2 - b.v2).length() < kSame;
}

QTableWidgetItem* cell(const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

} // namespace

LatticeTool::LatticeTool(ExemplarStore* store, Inspector* inspector, QWidget* parent)
    : QWidget(parent), m_store(store), m_inspector(inspector),
      m_canvas(new LatticeCanvas(LatticeCanvas::Style::Courses)),
      m_gamma(new LatticeCanvas(LatticeCanvas::Style::Points)), m_table(new QTableWidget(0, 3)),
      m_verdict(new QLabel), m_useText(new QLabel), m_bar(new TaskBar) {
    setObjectName(QStringLiteral("latticeTool"));
    m_canvas->setObjectName(QStringLiteral("latticeCanvas"));
    m_canvas->setAccessibleName(tr("Exemplar with its lattice"));
    m_canvas->setPlaceholder(tr("Open an exemplar to find its lattice."));
    m_gamma->setObjectName(QStringLiteral("correlationCanvas"));
    m_gamma->setAccessibleName(tr("Correlation of the exemplar with itself"));
    m_gamma->setToolTip(tr("How alike the exemplar is to itself when it is moved: bright where it repeats. "
                           "The lattice's points belong on the bright spots."));
    m_gamma->setPlaceholder(tr("The correlation of the exemplar with itself shows here."));
    m_gamma->setOriginFixed(true);

    auto* split = new QSplitter(Qt::Horizontal);
    split->addWidget(m_canvas);
    split->addWidget(makePanel());
    split->setStretchFactor(0, 1);
    split->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(split, 1);
    connectCanvases();
    connect(m_store, &ExemplarStore::changed, this, &LatticeTool::followExemplar);
    connect(m_store, &ExemplarStore::currentChanged, this, &LatticeTool::followExemplar);
    connect(m_inspector, &Inspector::edited, this, &LatticeTool::refreshUse);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_detection.cancel();
        m_bar->end();
        sayVerdict();
    });
    setLattice({});
}

QWidget* LatticeTool::makePanel() {
    makeTable();
    m_verdict->setObjectName(QStringLiteral("latticeVerdict"));
    m_useText->setObjectName(QStringLiteral("latticeUse"));
    for (QLabel* label : {m_verdict, m_useText}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto* panel = new QWidget;
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_gamma, 1);
    column->addWidget(m_bar);
    column->addWidget(m_verdict);
    column->addWidget(m_table);
    column->addWidget(makeButtons());
    column->addWidget(m_useText);
    column->addWidget(makeFields());
    auto* scroll = new QScrollArea;
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setMinimumWidth(panel->minimumSizeHint().width() + fontMetrics().averageCharWidth() * 3);
    return scroll;
}

void LatticeTool::makeTable() {
    m_table->setObjectName(QStringLiteral("latticeCandidates"));
    m_table->setAccessibleName(tr("Lattices to choose from"));
    m_table->setHorizontalHeaderLabels({tr("First vector"), tr("Second vector"), tr("Goodness")});
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setFixedHeight(fontMetrics().height() * 3 / 2 * kTableRows +
                            m_table->horizontalHeader()->sizeHint().height());
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (!m_filling)
            chooseRow(row);
    });
}

QWidget* LatticeTool::makeFields() {
    const std::array<QString, 3> titles = {tr("First vector"), tr("Second vector"), tr("Origin")};
    const std::array<const char*, 6> names = {"latticeV1x", "latticeV1y",     "latticeV2x",
                                              "latticeV2y", "latticeOriginX", "latticeOriginY"};
    auto* fields = new QWidget;
    auto* grid = new QGridLayout(fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("right, px")), 0, 1);
    grid->addWidget(new QLabel(tr("down, px")), 0, 2);
    for (int i = 0; i < 6; ++i) {
        auto* field = new QDoubleSpinBox;
        m_fields[static_cast<std::size_t>(i)] = field;
        field->setObjectName(QLatin1String(names[static_cast<std::size_t>(i)]));
        const QString& title = titles[static_cast<std::size_t>(i / 2)];
        field->setAccessibleName((i % 2 == 0 ? tr("%1, right") : tr("%1, down")).arg(title));
        field->setRange(-kLargest, kLargest);
        field->setDecimals(2);
        field->setSingleStep(0.1);
        field->setKeyboardTracking(false);
        field->setAlignment(Qt::AlignRight);
        field->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.00")) * 3 / 2);
        connect(field, &QDoubleSpinBox::valueChanged, this, [this] {
            if (!m_filling)
                fieldsEdited();
        });
        grid->addWidget(field, 1 + i / 2, 1 + i % 2);
        if (i % 2 == 0)
            grid->addWidget(new QLabel(title), 1 + i / 2, 0);
    }
    m_fields[4]->setToolTip(tr("Where a tile begins. The methods choose by themselves until it is moved."));
    m_fields[5]->setToolTip(m_fields[4]->toolTip());
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    return fields;
}

QWidget* LatticeTool::makeButtons() {
    m_detect = new QPushButton(tr("Detect"));
    m_detect->setObjectName(QStringLiteral("detectLattice"));
    m_detect->setToolTip(tr("Look for the lattice in the exemplar again"));
    m_fit = new QPushButton(tr("Fit"));
    m_fit->setObjectName(QStringLiteral("fitLattice"));
    m_fit->setToolTip(tr("Move the vectors so that all their multiples come nearest to the bright spots"));
    m_use = new QPushButton;
    m_use->setObjectName(QStringLiteral("useLattice"));
    connect(m_detect, &QPushButton::clicked, this, &LatticeTool::detect);
    connect(m_fit, &QPushButton::clicked, this, &LatticeTool::refit);
    connect(m_use, &QPushButton::clicked, this, &LatticeTool::use);
    auto* buttons = new QWidget;
    auto* grid = new QGridLayout(buttons);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(m_detect, 0, 0);
    grid->addWidget(m_fit, 0, 1);
    grid->addWidget(m_use, 1, 0, 1, 2);
    return buttons;
}

void LatticeTool::connectCanvases() {
    for (LatticeCanvas* canvas : {m_canvas, m_gamma}) {
        LatticeCanvas* const other = canvas == m_canvas ? m_gamma : m_canvas;
        connect(canvas, &LatticeCanvas::edited, this,
                [this, canvas](LatticeCanvas::Handle handle) { canvasEdited(canvas, handle); });
        connect(canvas, &LatticeCanvas::handleChanged, other, [other](LatticeCanvas::Handle handle) {
            if (handle != LatticeCanvas::Handle::Origin)
                other->setHandle(handle);
        });
    }
}

void LatticeTool::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    followExemplar();
}

void LatticeTool::followExemplar() {
    const ExemplarEntry* const entry = m_store->current();
    const std::shared_ptr<const Image> image = entry != nullptr ? entry->file().image : nullptr;
    if (!isVisible() || image == m_exemplar)
        return;
    m_exemplar = image;
    m_name = entry != nullptr ? QString::fromStdString(entry->file().name()) : QString();
    m_detection.cancel();
    m_bar->end();
    m_analysis.reset();
    m_failure.clear();
    m_canvas->setPicture(entry != nullptr ? entry->picture : nullptr);
    m_gamma->setPicture(nullptr);
    m_originMoved = false;
    setLattice(entry != nullptr && m_inspector->method() != nullptr
                   ? givenLattice(*m_inspector->method(), m_inspector->values())
                   : std::nullopt);
    m_edited = lattice().has_value();
    fillTable();
    if (image && latticeSecondsFor(image->size()) <= kAtOnce)
        detect();
    else
        sayVerdict();
}

void LatticeTool::detect() {
    if (!m_exemplar)
        return;
    m_failure.clear();
    m_detection.start(
        {},
        [image = m_exemplar](JobContext& context) {
            const std::uint64_t bytes = latticeBytesFor(image->size(), image->channels());
            if (bytes > availableMemory())
                fail("Finding the lattice takes {}, of which only {} are free; open a smaller exemplar.",
                     byteText(bytes), byteText(availableMemory()));
            Detected detected;
            detected.analysis =
                std::make_shared<const LatticeAnalysis>(analyzeLattice(*image, [&] { context.check(); }));
            detected.picture = pictureOf(detected.analysis->correlation);
            return detected;
        },
        [this](Detected detected) { take(std::move(detected)); },
        [this](const QString& why) {
            m_bar->end();
            m_failure = why;
            sayVerdict();
        });
    m_bar->begin(tr("Looking for the lattice…"), [this] { return m_detection.progress(); });
    sayVerdict();
}

void LatticeTool::take(Detected detected) {
    m_bar->end();
    m_analysis = std::move(detected.analysis);
    m_gamma->setPicture(std::move(detected.picture));
    if (!m_edited && !m_analysis->candidates.empty())
        setLattice(m_analysis->candidates.front().lattice);
    else
        setLattice(lattice());
    lookAtVectors();
    fillTable();
    sayVerdict();
}

/// A few multiples of the vectors, as large as the correlation's viewer allows.
void LatticeTool::lookAtVectors() {
    if (!lattice() || !m_gamma->picture())
        return;
    constexpr double kMultiples = 6;
    const double longest = std::max(lattice()->v1.length(), lattice()->v2.length());
    const Size size = m_gamma->picture()->size();
    m_gamma->lookAt({0.5 * size.width, 0.5 * size.height},
                    std::min<double>(size.shorterSide(), kMultiples * longest));
}

void LatticeTool::fillTable() {
    m_filling = true;
    m_table->setRowCount(0);
    if (m_analysis)
        for (const LatticeCandidate& candidate : m_analysis->candidates) {
            const int row = m_table->rowCount();
            m_table->insertRow(row);
            m_table->setItem(row, 0, cell(vectorText(candidate.lattice.v1, 1)));
            m_table->setItem(row, 1, cell(vectorText(candidate.lattice.v2, 1)));
            m_table->setItem(row, 2, cell(QString::number(candidate.goodness, 'f', 2)));
            m_table->item(row, 2)->setToolTip(tr("Mean correlation %1 over %2 multiples of the vectors")
                                                  .arg(candidate.correlation, 0, 'f', 2)
                                                  .arg(candidate.multiples));
            if (lattice() && same(*lattice(), candidate.lattice))
                m_table->selectRow(row);
        }
    m_table->setEnabled(m_table->rowCount() > 0);
    m_filling = false;
}

void LatticeTool::chooseRow(int row) {
    if (!m_analysis || row < 0 || row >= static_cast<int>(m_analysis->candidates.size()))
        return;
    m_edited = false;
    setLattice(m_analysis->candidates[static_cast<std::size_t>(row)].lattice);
}

/// A place for the arrows in the middle of the exemplar, on a multiple of the vectors.
Vec2 LatticeTool::middleOrigin(const Lattice& lattice) const {
    if (!m_exemplar || lattice.area() < 1e-6)
        return {};
    const Vec2 middle{0.5 * m_exemplar->width(), 0.5 * m_exemplar->height()};
    return lattice.nearest(middle - lattice.at(0.5, 0.5));
}

void LatticeTool::setLattice(const std::optional<Lattice>& lattice) {
    const Vec2 origin = !lattice ? Vec2{} : m_originMoved ? m_canvas->origin() : middleOrigin(*lattice);
    m_canvas->setLattice(lattice, origin);
    setOrigin(origin);
}

void LatticeTool::setOrigin(Vec2 origin) {
    m_canvas->setLattice(lattice(), origin);
    if (m_analysis)
        m_gamma->setLattice(lattice(),
                            {m_analysis->correlation.left() + 0.5, m_analysis->correlation.top() + 0.5});
    showFields();
    refreshUse();
}

void LatticeTool::canvasEdited(LatticeCanvas* canvas, LatticeCanvas::Handle handle) {
    if (handle == LatticeCanvas::Handle::Origin) {
        m_originMoved = true;
    } else {
        m_edited = true;
        m_canvas->setLattice(canvas->lattice(), m_canvas->origin());
        const QSignalBlocker blocker(m_table);
        m_table->clearSelection();
    }
    setOrigin(m_canvas->origin());
}

void LatticeTool::fieldsEdited() {
    const auto value = [&](std::size_t i) { return m_fields[i]->value(); };
    const Lattice typed{{value(0), value(1)}, {value(2), value(3)}};
    const Vec2 origin{value(4), value(5)};
    m_originMoved = m_originMoved || (origin - m_canvas->origin()).length() > kSame;
    if (!lattice() || !same(typed, *lattice())) {
        m_edited = true;
        const QSignalBlocker blocker(m_table);
        m_table->clearSelection();
    }
    m_canvas->setLattice(typed.v1.length() + typed.v2.length() > 0 ? std::optional(typed) : std::nullopt,
                         origin);
    setOrigin(origin);
}

void LatticeTool::showFields() {
    m_filling = true;
    const Lattice shown = lattice().value_or(Lattice{{0, 0}, {0, 0}});
    const Vec2 origin = m_canvas->origin();
    const std::array<double, 6> values = {shown.v1.x, shown.v1.y, shown.v2.x, shown.v2.y, origin.x, origin.y};
    for (std::size_t i = 0; i < values.size(); ++i)
        m_fields[i]->setValue(values[i]);
    m_filling = false;
}

void LatticeTool::refit() {
    if (!m_analysis || !lattice())
        return;
    m_fitting.start(
        {},
        [analysis = m_analysis, rough = *lattice()](JobContext& context) {
            return fittedLattice(analysis->correlation, rough, [&] { context.check(); });
        },
        [this](const LatticeCandidate& candidate) {
            m_edited = true;
            setLattice(candidate.lattice);
        },
        [this](const QString& why) {
            m_failure = why;
            sayVerdict();
        });
}

QString LatticeTool::problem() const {
    if (!lattice() || !m_exemplar)
        return {};
    LatticeSettings settings;
    settings.lattice = LatticeSource::Given;
    settings.v1x = lattice()->v1.x;
    settings.v1y = lattice()->v1.y;
    settings.v2x = lattice()->v2.x;
    settings.v2y = lattice()->v2.y;
    try {
        checkLattice(settings, m_name.toStdString(), m_exemplar->size());
    } catch (const std::exception& error) {
        return translated(sentence(error).toStdString());
    }
    return {};
}

void LatticeTool::use() {
    const Method* method = m_inspector->method();
    if (!lattice() || method == nullptr)
        return;
    if (!followsLattice(*method)) {
        Q_EMIT methodWanted(kMethod);
        method = m_inspector->method();
    }
    const std::optional<Vec2> origin = m_originMoved ? std::optional(m_canvas->origin()) : std::nullopt;
    m_inspector->changeValues(latticeValues(*method, *lattice(), origin));
}

void LatticeTool::refreshUse() {
    const Method* const method = m_inspector->method();
    if (method == nullptr)
        return;
    const bool follows = followsLattice(*method);
    const Method& user = follows ? *method : findMethod(kMethod.toStdString());
    const QString title = translated(user.info().title);
    m_use->setText(tr("Use in %1").arg(title));
    const QString why = problem();
    m_use->setEnabled(lattice() && m_exemplar && why.isEmpty());
    m_fit->setEnabled(lattice() && m_analysis && why.isEmpty());
    m_detect->setEnabled(m_exemplar != nullptr);
    for (QDoubleSpinBox* field : m_fields)
        field->setEnabled(m_exemplar != nullptr);
    const std::optional<Lattice> given = givenLattice(*method, m_inspector->values());
    QString text;
    if (!why.isEmpty())
        text = why;
    else if (!follows)
        text = tr("%1 follows no lattice.").arg(translated(method->info().title));
    else if (!given)
        text = m_inspector->values().at("lattice") == Value(std::string("none"))
                   ? tr("%1 is set to use no lattice.").arg(title)
                   : tr("%1 looks for the lattice by itself.").arg(title);
    else if (lattice() && same(*given, *lattice()))
        text = tr("✓ %1 uses this lattice.").arg(title);
    else
        text = tr("%1 uses another lattice: %2 and %3 px.")
                   .arg(title, vectorText(given->v1), vectorText(given->v2));
    if (why.isEmpty() && lattice() && m_exemplar &&
        (2 * lattice()->extent().x > m_exemplar->width() || 2 * lattice()->extent().y > m_exemplar->height()))
        text +=
            tr(" The exemplar holds fewer than two of these tiles on a side, so results repeat much of it.");
    m_useText->setText(text);
}

void LatticeTool::sayVerdict() {
    QString text;
    if (!m_failure.isEmpty())
        text = m_failure;
    else if (m_detection.running())
        text = QString();
    else if (!m_exemplar)
        text = tr("Open an exemplar first.");
    else if (!m_analysis)
        text = tr("Press Detect to look for the lattice, or give its vectors.");
    else if (m_analysis->found())
        text = tr("%1 repeats itself by this lattice (confidence %2).")
                   .arg(m_name, percentText(m_analysis->confidence));
    else if (m_analysis->candidates.empty())
        text =
            tr("Nothing in %1 repeats itself. A vector must fit into the exemplar about twice to be found. "
               "If you see it repeat, give the vectors; if not, methods without a lattice suit it, such as "
               "image quilting.")
                .arg(m_name);
    else
        text =
            tr("No lattice stands out in %1 (confidence %2). Choose one below, or drag the vectors to what "
               "you see; if it does not repeat, methods without a lattice suit it, such as image "
               "quilting.")
                .arg(m_name, percentText(m_analysis->confidence));
    m_verdict->setVisible(!text.isEmpty());
    m_verdict->setText(text);
    refreshUse();
}

QString LatticeTool::verdict() const {
    return m_verdict->text();
}

QString LatticeTool::useText() const {
    return m_useText->text();
}

} // namespace texloom::ui
