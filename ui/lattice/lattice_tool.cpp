#include "ui/lattice/lattice_tool.h"

#include "core/analysis/lattice_values.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/memory.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/jobs/task_bar.h"
#include "ui/lattice/candidate_table.h"
#include "ui/lattice/correlation_picture.h"
#include "ui/lattice/lattice_fields.h"
#include "ui/lattice/lattice_text.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

/// The method that uses a lattice when the one chosen does not: the first of those that follow one.
const Method* firstFollower() {
    const std::vector<const Method*> all = methodsByCategory();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [](const Method* method) { return followsLattice(method->params()); });
    return found != all.end() ? *found : nullptr;
}

/// An exemplar whose lattice takes longer than this, in seconds, is looked at only when asked.
constexpr double kAtOnce = 4;

} // namespace

LatticeTool::LatticeTool(ExemplarStore* store, Inspector* inspector, QWidget* parent)
    : QWidget(parent), m_store(store), m_inspector(inspector),
      m_canvas(new LatticeCanvas(LatticeCanvas::Style::Courses)),
      m_gamma(new LatticeCanvas(LatticeCanvas::Style::Points)), m_table(new CandidateTable),
      m_fields(new LatticeFields), m_verdict(new QLabel), m_useText(new QLabel), m_bar(new TaskBar) {
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
    connect(m_table, &CandidateTable::chosen, this, [this](const LatticeCandidate& candidate) {
        const Drawn before = drawn();
        m_edited = false;
        setLattice(candidate.lattice);
        tellOf(before);
    });
    connect(m_fields, &LatticeFields::edited, this, &LatticeTool::fieldsEdited);
    connect(m_inspector, &Inspector::edited, this, &LatticeTool::refreshUse);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_detection.cancel();
        m_bar->end();
        sayVerdict();
    });
    setLattice({});
}

QWidget* LatticeTool::makePanel() {
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
    column->addWidget(m_fields);
    auto* scroll = new QScrollArea;
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setMinimumWidth(panel->minimumSizeHint().width() + fontMetrics().averageCharWidth() * 3);
    return scroll;
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
    m_given.follow(entry, *m_inspector);
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
                   ? givenLattice(m_inspector->method()->params(), m_inspector->values())
                   : std::nullopt);
    m_edited = lattice().has_value();
    m_table->list(m_analysis, lattice());
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
            detected.picture = pictureOf(detected.analysis->rating());
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
    m_table->list(m_analysis, lattice());
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

/// A place for the arrows in the middle of the exemplar, on a multiple of the vectors where those repeat.
Vec2 LatticeTool::middleOrigin(const Lattice& lattice) const {
    if (!m_exemplar || lattice.area() < 1e-6)
        return {};
    const Vec2 middle{0.5 * m_exemplar->width(), 0.5 * m_exemplar->height()};
    const Vec2 start = middle - lattice.at(0.5, 0.5);
    return lattice.keepsOrder(m_exemplar->size()) ? start : lattice.nearest(start);
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
    m_fields->setLattice(lattice(), origin);
    m_shown = lattice();
    m_shownOrigin = origin;
    refreshUse();
}

LatticeTool::Drawn LatticeTool::drawn() const {
    return {m_exemplar, m_shown, m_shownOrigin, m_originMoved, m_edited};
}

void LatticeTool::tellOf(const Drawn& before) {
    rate();
    Q_EMIT drawnAnew(before, drawn());
}

void LatticeTool::restore(const Drawn& drawn) {
    if (drawn.exemplar != m_exemplar)
        return;
    m_originMoved = drawn.originMoved;
    m_edited = drawn.edited;
    m_canvas->setLattice(drawn.lattice, drawn.origin);
    setOrigin(drawn.origin);
    m_table->list(m_analysis, lattice());
    rate();
}

/// How well the exemplar agrees with vectors set by hand, found out beside everything else.
void LatticeTool::rate() {
    m_rating.reset();
    m_ratingTask.cancel();
    if (m_edited && m_analysis && lattice() && problem().isEmpty())
        m_ratingTask.start(
            {},
            [analysis = m_analysis, lattice = *lattice()](JobContext& context) {
                return ratedLattice(analysis->rating(), lattice, [&] { context.check(); });
            },
            [this](const LatticeCandidate& rating) {
                m_rating = rating;
                sayVerdict();
            },
            [](const QString&) {});
    sayVerdict();
}

void LatticeTool::canvasEdited(LatticeCanvas* canvas, LatticeCanvas::Handle handle) {
    const Drawn before = drawn();
    if (handle == LatticeCanvas::Handle::Origin) {
        m_originMoved = true;
    } else {
        m_edited = true;
        m_canvas->setLattice(canvas->lattice(), m_canvas->origin());
        m_table->chooseNone();
    }
    setOrigin(m_canvas->origin());
    tellOf(before);
}

void LatticeTool::fieldsEdited() {
    const Drawn before = drawn();
    const std::optional<Lattice> typed = m_fields->lattice();
    const Vec2 origin = m_fields->origin();
    m_originMoved = m_originMoved || (origin - m_canvas->origin()).length() > kSameVectors;
    if (!typed || !lattice() || !sameVectors(*typed, *lattice())) {
        m_edited = true;
        m_table->chooseNone();
    }
    m_canvas->setLattice(typed, origin);
    setOrigin(origin);
    tellOf(before);
}

void LatticeTool::refit() {
    if (!m_analysis || !lattice())
        return;
    m_fitting.start(
        {},
        [analysis = m_analysis, rough = *lattice()](JobContext& context) {
            return fittedLattice(analysis->rating(), rough, [&] { context.check(); });
        },
        [this](const LatticeCandidate& candidate) {
            const Drawn before = drawn();
            m_edited = true;
            setLattice(candidate.lattice);
            tellOf(before);
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
        return sentence(error);
    }
    return {};
}

void LatticeTool::use() {
    const Method* method = m_inspector->method();
    if (!lattice() || method == nullptr)
        return;
    if (!followsLattice(method->params())) {
        Q_EMIT methodWanted(QString::fromStdString(firstFollower()->id()));
        method = m_inspector->method();
    }
    const std::optional<Vec2> origin = m_originMoved ? std::optional(m_canvas->origin()) : std::nullopt;
    m_inspector->changeValues(latticeValues(method->params(), *lattice(), origin));
}

void LatticeTool::refreshUse() {
    const Method* const method = m_inspector->method();
    if (method == nullptr)
        return;
    const bool follows = followsLattice(method->params());
    const Method* const user = follows ? method : firstFollower();
    m_use->setVisible(user != nullptr);
    if (user == nullptr)
        return;
    const QString title = translated(user->info().title);
    m_use->setText(tr("Use in %1").arg(title));
    const QString why = problem();
    m_use->setEnabled(lattice() && m_exemplar && why.isEmpty());
    m_fit->setEnabled(lattice() && m_analysis && why.isEmpty());
    m_detect->setEnabled(m_exemplar != nullptr);
    m_fields->setEnabled(m_exemplar != nullptr);
    const std::optional<Lattice> given = givenLattice(method->params(), m_inspector->values());
    QString text;
    if (!why.isEmpty())
        text = why;
    else if (!follows)
        text = tr("%1 follows no lattice.").arg(translated(method->info().title));
    else if (!given)
        text = latticeSource(method->params(), m_inspector->values()) == LatticeSource::None
                   ? tr("%1 is set to use no lattice.").arg(title)
                   : tr("%1 looks for the lattice by itself.").arg(title);
    else if (lattice() && sameVectors(*given, *lattice()))
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
    else if (m_edited && m_rating)
        text = tr("Set by hand: %1 agrees with itself by %2 at the multiples of these vectors; by %3 at "
                  "those of "
                  "the best that was found.")
                   .arg(m_name, percentText(m_rating->correlation),
                        percentText(
                            m_analysis->candidates.empty() ? 0 : m_analysis->candidates.front().correlation));
    else if (m_analysis->found() && m_analysis->candidates.front().lattice.keepsOrder(m_exemplar->size()))
        text =
            tr("Nothing in %1 repeats itself, but rows run through all of it (confidence %2): they keep "
               "their order, and begin again after %3 px. If you see it repeat, rectify the exemplar first "
               "(Ctrl+D) where it is seen at an angle, or drag the vectors.")
                .arg(m_name, percentText(m_analysis->confidence))
                .arg(m_analysis->candidates.front().lattice.area(), 0, 'f', 0);
    else if (m_analysis->found() && m_analysis->candidates.front().lattice.rowsOnly())
        text =
            tr("%1 repeats itself in rows (confidence %2); what lies along them may come from anywhere in a "
               "row.")
                .arg(m_name, percentText(m_analysis->confidence));
    else if (m_analysis->found())
        text = tr("%1 repeats itself by this lattice (confidence %2).")
                   .arg(m_name, percentText(m_analysis->confidence));
    else if (m_analysis->candidates.empty())
        text =
            tr("Nothing in %1 repeats itself. A vector must fit into the exemplar about twice to be found. "
               "If you see it repeat, give the vectors, or rectify the exemplar first (Ctrl+D) where it is "
               "seen at an angle; if not, methods without a lattice suit it, such as image quilting.")
                .arg(m_name);
    else
        text =
            tr("No lattice stands out in %1 (confidence %2). Choose one below, drag the vectors to what you "
               "see, or rectify the exemplar first (Ctrl+D) where it is seen at an angle; if it does not "
               "repeat, methods without a lattice suit it, such as image quilting.")
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
