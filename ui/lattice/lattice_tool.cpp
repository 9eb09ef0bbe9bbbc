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
#include "ui/lattice/lattice_previews.h"
#include "ui/lattice/lattice_search_form.h"
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
      m_search(new LatticeSearchForm), m_fields(new LatticeFields), m_previews(new LatticePreviews(this)),
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
    connect(m_table, &CandidateTable::chosen, this, [this](const LatticeCandidate& candidate) {
        const Drawn before = drawn();
        m_edited = false;
        setLattice(candidate.lattice);
        tellOf(before);
    });
    connect(m_previews, &LatticePreviews::made, m_table, &CandidateTable::setResult);
    connect(m_previews, &LatticePreviews::failed, m_table, &CandidateTable::setNoResult);
    connect(m_search, &LatticeSearchForm::edited, this, &LatticeTool::searchEdited);
    connect(m_fields, &LatticeFields::edited, this, &LatticeTool::fieldsEdited);
    connect(m_inspector, &Inspector::edited, this, &LatticeTool::refreshUse);
    connect(m_inspector, &Inspector::edited, this, &LatticeTool::previewCandidates);
    connect(m_bar, &TaskBar::cancelled, this, [this] {
        m_detection.cancel();
        m_bar->end();
        sayVerdict();
    });
    connect(m_search, &LatticeSearchForm::folded, this, &LatticeTool::refreshUse);
    m_previews->setObjectName(QStringLiteral("latticePreviews"));
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
    column->addWidget(m_search);
    QScrollArea* const scroll = m_scroll = new QScrollArea;
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
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
    m_previews->cancel();
    m_previewed = {};
    m_kept = false;
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
        [image = m_exemplar, criteria = m_criteria](JobContext& context) {
            const std::uint64_t bytes = latticeBytesFor(image->size(), image->channels());
            if (bytes > availableMemory())
                fail("Finding the lattice takes {}, of which only {} are free; open a smaller exemplar.",
                     byteText(bytes), byteText(availableMemory()));
            Detected detected;
            detected.analysis = std::make_shared<const LatticeAnalysis>(analyzeLattice(
                *image, [&] { context.check(); }, criteria));
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
    if (!m_edited && !m_kept && !m_analysis->candidates.empty())
        setLattice(m_analysis->candidates.front().lattice);
    else
        setLattice(lattice());
    m_kept = false;
    lookAtVectors();
    m_table->list(m_analysis, lattice());
    previewCandidates();
    rate();
}

const Method* LatticeTool::user() const {
    const Method* const chosen = m_inspector->method();
    return chosen != nullptr && followsLattice(chosen->params()) ? chosen : firstFollower();
}

/// Shows what each candidate would give with the method that uses lattices.
void LatticeTool::previewCandidates() {
    const Method* const method = user();
    if (method == nullptr || !m_analysis || !m_exemplar || m_detection.running() ||
        (m_previewed.analysis == m_analysis && m_previewed.method == method))
        return;
    m_previewed = {m_analysis, method};
    std::vector<Lattice> lattices;
    for (const LatticeCandidate& candidate : m_analysis->candidates) {
        m_table->setResult(static_cast<int>(lattices.size()), nullptr);
        lattices.push_back(candidate.lattice);
    }
    m_previews->make(*method, m_exemplar, std::move(lattices));
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
    return {m_exemplar, m_shown, m_shownOrigin, m_originMoved, m_edited, m_criteria};
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
    const bool searchesAnew = drawn.criteria != m_criteria;
    m_criteria = drawn.criteria;
    m_search->setCriteria(m_criteria);
    m_canvas->setLattice(drawn.lattice, drawn.origin);
    setOrigin(drawn.origin);
    m_table->list(m_analysis, lattice());
    rate();
    if (searchesAnew) {
        m_kept = !drawn.toBeFound;
        detect();
    }
}

void LatticeTool::searchEdited() {
    const Drawn before = drawn();
    m_criteria = m_search->criteria();
    m_kept = false;
    Drawn after = drawn();
    after.toBeFound = true;
    detect();
    Q_EMIT drawnAnew(before, after);
}

/// How well the exemplar agrees with vectors set by hand, found out beside everything else.
void LatticeTool::rate() {
    m_rating.reset();
    m_ratingTask.cancel();
    if (m_edited && m_analysis && lattice() && problem().isEmpty())
        m_ratingTask.start(
            {},
            [analysis = m_analysis, lattice = *lattice()](JobContext& context) {
                return ratedLattice(*analysis, lattice, [&] { context.check(); });
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
            return fittedLattice(*analysis, rough, [&] { context.check(); });
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

void LatticeTool::use() {
    const Method* method = m_inspector->method();
    if (!lattice() || method == nullptr)
        return;
    if (!followsLattice(method->params())) {
        Q_EMIT methodWanted(QString::fromStdString(user()->id()));
        method = m_inspector->method();
    }
    const std::optional<Vec2> origin = m_originMoved ? std::optional(m_canvas->origin()) : std::nullopt;
    m_inspector->changeValues(latticeValues(method->params(), *lattice(), origin));
}

} // namespace texloom::ui
