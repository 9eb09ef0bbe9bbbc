#include "ui/maps/result_view.h"

#include "core/analysis/map_pictures.h"
#include "ui/common/background.h"
#include "ui/common/elided_label.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/maps/map_page.h"
#include "ui/maps/result_maps.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// The exemplar in grey under its position map: the legend on what it is the legend of.
Image legendOver(const Image& exemplar, const Image& positions) {
    constexpr float kColour = 0.6F;
    Image mixed(positions);
    const int channels = std::min(3, exemplar.channels());
    for (int y = 0; y < mixed.height(); ++y)
        for (int x = 0; x < mixed.width(); ++x) {
            float grey = 0;
            for (int c = 0; c < channels; ++c)
                grey += exemplar(x, y, c) / static_cast<float>(channels);
            grey = std::clamp(grey, 0.0F, 1.0F);
            for (int c = 0; c < mixed.channels(); ++c)
                mixed(x, y, c) = kColour * mixed(x, y, c) + (1 - kColour) * grey;
        }
    return mixed;
}

QString trustIn(MapKind kind) {
    switch (kind) {
    case MapKind::Exact:
        return ResultView::tr("Exact: every pixel is a copy of the exemplar's pixel of this colour.");
    case MapKind::Dominant:
        return ResultView::tr("Pixels are blends: each has the colour of the source that weighs most.");
    case MapKind::Estimated:
        return ResultView::tr("Estimated: the place in the exemplar that each new pixel is most like.");
    case MapKind::None:
        break;
    }
    return {};
}

} // namespace

ResultView::ResultView(QWidget* parent)
    : QWidget(parent), m_title(new ElidedLabel(this)), m_wrapOffer(new QPushButton(this)),
      m_rerunOffer(new QPushButton(this)), m_notes(new MessageBar(this)), m_tabs(new QTabWidget(this)),
      m_maps(new ResultMaps(this)) {
    m_title->setObjectName(QStringLiteral("resultTitle"));
    m_notes->setObjectName(QStringLiteral("resultNotes"));
    m_tabs->setObjectName(QStringLiteral("resultTabs"));
    m_tabs->setDocumentMode(true);
    auto* result = new ImageViewer(m_tabs);
    result->setObjectName(QStringLiteral("resultViewer"));
    m_viewers[ResultTab] = addViewer(result, result, tr("Result"));
    m_synthesis = addMap(QStringLiteral("synthesisViewer"), tr("Synthesis map"));
    m_viewers[SynthesisTab] = m_synthesis->viewer();
    auto* position = new ImageViewer(m_tabs);
    position->setObjectName(QStringLiteral("positionViewer"));
    m_viewers[PositionTab] = addViewer(position, position, tr("Position map"));
    m_copies = addMap(QStringLiteral("copiesViewer"), tr("Copied pieces"));
    m_viewers[CopiesTab] = m_copies->viewer();
    m_tabs->setTabToolTip(SynthesisTab, tr("Every pixel in the colour that the position map gives its "
                                           "source: even areas are copied as they are."));
    m_tabs->setTabToolTip(PositionTab,
                          tr("The legend of the synthesis map: a colour for every pixel of the exemplar."));
    m_tabs->setTabToolTip(CopiesTab,
                          tr("What was copied in one piece: an even colour for each, with black borders."));
    for (const Tab from : {ResultTab, SynthesisTab, CopiesTab}) {
        connect(viewer(from), &ImageViewer::hovered, this, &ResultView::resultHovered);
        for (const Tab to : {ResultTab, SynthesisTab, CopiesTab})
            if (from != to)
                share(viewer(from), viewer(to));
    }
    connect(viewer(PositionTab), &ImageViewer::hovered, this, &ResultView::positionHovered);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(makeTitleRow());
    column->addWidget(m_notes);
    column->addWidget(m_tabs, 1);
    viewer(ResultTab)->setPlaceholder(tr("No result yet. Press Run."));
    viewer(PositionTab)->setPlaceholder(tr("Open an exemplar to see its position map."));
    connectMaps();
    explainMaps();
}

QLayout* ResultView::makeTitleRow() {
    m_wrapOffer->setObjectName(QStringLiteral("wrapOffer"));
    m_wrapOffer->setText(tr("Does not wrap: make it wrap"));
    m_wrapOffer->setToolTip(tr("Ticks both axes under “Wraps” and runs these settings again."));
    m_rerunOffer->setObjectName(QStringLiteral("rerunOffer"));
    m_rerunOffer->setText(tr("Made before the edit: run again"));
    m_rerunOffer->setToolTip(tr("The exemplar was edited since; runs these settings on it as it is now."));
    connect(m_wrapOffer, &QPushButton::clicked, this, &ResultView::wrapWanted);
    connect(m_rerunOffer, &QPushButton::clicked, this, &ResultView::rerunWanted);
    setOffers(false, false);
    auto* row = new QHBoxLayout;
    row->addWidget(m_title, 1);
    row->addWidget(m_rerunOffer);
    row->addWidget(m_wrapOffer);
    return row;
}

void ResultView::setOffers(bool wrap, bool rerun) {
    m_wrapOffer->setVisible(wrap);
    m_rerunOffer->setVisible(rerun);
}

ImageViewer* ResultView::addViewer(ImageViewer* viewer, QWidget* page, const QString& title) {
    viewer->setAccessibleName(title);
    m_tabs->addTab(page, title);
    connect(viewer, &ImageViewer::unhovered, this, &ResultView::unhovered);
    return viewer;
}

MapPage* ResultView::addMap(const QString& name, const QString& title) {
    auto* page = new MapPage(name, m_tabs);
    addViewer(page->viewer(), page, title);
    connect(page, &MapPage::estimateWanted, this, [this] {
        m_maps->estimate();
        explainMaps();
    });
    connect(page, &MapPage::cancelled, this, [this] {
        m_maps->cancel();
        explainMaps();
    });
    return page;
}

void ResultView::connectMaps() {
    connect(m_tabs, &QTabWidget::currentChanged, this, &ResultView::tabChanged);
    connect(m_tabs, &QTabWidget::currentChanged, this, &ResultView::tabShown);
    connect(m_maps, &ResultMaps::copiesChanged, this, &ResultView::showCopiesPicture);
    connect(m_maps, &ResultMaps::estimated, this, [this] {
        showMapPictures();
        setBadge(m_runBadge);
    });
    connect(m_maps, &ResultMaps::failed, this, [this](const QString& why) {
        explainMaps();
        for (MapPage* page : {m_synthesis, m_copies})
            page->setLine(why);
    });
}

void ResultView::share(ImageViewer* from, ImageViewer* to) {
    connect(from, &ImageViewer::viewChanged, to, [from, to] {
        const QSignalBlocker blocker(to);
        if (from->picture() && to->picture() && from->picture()->size() == to->picture()->size())
            to->setView(from->view(), from->fitted());
    });
}

const RunPictures& ResultView::pictures() const {
    return m_maps->pictures();
}

void ResultView::showPictures(const RunPictures& pictures) {
    m_maps->follow(pictures);
    viewer(ResultTab)->setPicture(pictures.result);
    hideCopies();
    showMapPictures();
}

void ResultView::showMapPictures() {
    const auto shared = [this](ImageViewer* to) {
        if (to->picture())
            to->setView(viewer(ResultTab)->view(), viewer(ResultTab)->fitted());
    };
    viewer(SynthesisTab)->setPicture(pictures().synthesis);
    shared(viewer(SynthesisTab));
    showCopiesPicture();
    explainMaps();
}

void ResultView::showCopiesPicture() {
    const bool wanted = m_tabs->currentIndex() == CopiesTab && pictures().run;
    const auto copies = wanted ? m_maps->copies() : std::nullopt;
    ImageViewer* const shown = viewer(CopiesTab);
    shown->setPicture(copies ? copies->picture : nullptr);
    if (copies)
        shown->setView(viewer(ResultTab)->view(), viewer(ResultTab)->fitted());
    m_copies->setLine(copies ? tr("The largest piece copied as it is takes %1 of the result.%2")
                                   .arg(QStringLiteral("%1 %").arg(100 * copies->largest, 0, 'f', 1),
                                        pictures().mapKind == MapKind::Exact
                                            ? QString()
                                            : QLatin1Char(' ') + trustIn(pictures().mapKind))
                             : QString());
}

void ResultView::explainMaps() {
    const bool run = pictures().run != nullptr;
    const bool estimating = m_maps->estimating();
    const QString none =
        !pictures().result ? tr("No result yet. The map shows where each of its pixels came from.")
        : !run             ? tr("This method tells where pixels came from only at its end, or not at all.")
        : pictures().run->plan.request.exemplars.empty()
            ? tr("This method learned from no exemplar, so there is no map of where its pixels came from.")
            : tr("This method makes new pixels and copies none, so there is no map of where they came "
                 "from. An estimated one shows what in the exemplar each is most like.");
    viewer(SynthesisTab)->setPlaceholder(none);
    viewer(CopiesTab)->setPlaceholder(run && pictures().map ? tr("Looking at what was copied…") : none);
    for (MapPage* page : {m_synthesis, m_copies}) {
        page->setOffer(m_maps->canEstimate() && !estimating);
        page->setProgress(estimating ? [this] { return m_maps->progress(); } : std::function<double()>());
    }
    m_synthesis->setLine(run ? trustIn(pictures().mapKind) : QString());
}

void ResultView::tabChanged() {
    if (m_tabs->currentIndex() == CopiesTab)
        showCopiesPicture();
    const bool map = m_tabs->currentIndex() == SynthesisTab || m_tabs->currentIndex() == PositionTab;
    Q_EMIT legendChanged(map ? m_legend.over : nullptr);
}

QString ResultView::mapLine(Tab tab) const {
    return tab == CopiesTab ? m_copies->line() : m_synthesis->line();
}

std::size_t ResultView::showCopies(const Source& source) {
    const std::vector<QPoint> places = m_maps->copiesOf(source);
    for (const Tab tab : {ResultTab, SynthesisTab, CopiesTab})
        viewer(tab)->setRings(places);
    return places.size();
}

void ResultView::hideCopies() {
    for (const Tab tab : {ResultTab, SynthesisTab, CopiesTab})
        viewer(tab)->setRings({});
}

void ResultView::setTitle(const QString& text) {
    m_title->setFullText(text);
}

QString ResultView::title() const {
    return m_title->fullText();
}

void ResultView::setBadge(const QString& text) {
    m_runBadge = text;
    viewer(ResultTab)->setBadge(text);
    const bool estimated = pictures().run && pictures().mapKind == MapKind::Estimated;
    for (const Tab tab : {SynthesisTab, CopiesTab})
        viewer(tab)->setBadge(!estimated       ? text
                              : text.isEmpty() ? tr("Estimated")
                                               : tr("%1 · estimated").arg(text));
}

void ResultView::setExemplar(const ExemplarEntry* entry, int index, int count) {
    const int request = ++m_request;
    m_exemplar = entry != nullptr ? entry->id : 0;
    if (entry == nullptr) {
        m_legend = {};
        viewer(PositionTab)->setPicture(nullptr);
        return tabChanged();
    }
    const auto make = [exemplar = entry->file().image, index, count] {
        auto positions = std::make_shared<const Image>(positionPicture(exemplar->size(), index, count));
        auto over = std::make_shared<const Image>(legendOver(*exemplar, *positions));
        return Legend{std::make_shared<const DisplayPicture>(std::move(positions)),
                      std::make_shared<const DisplayPicture>(std::move(over))};
    };
    inBackground(
        this, make,
        [this, request](Legend legend) {
            if (request != m_request)
                return;
            m_legend = std::move(legend);
            viewer(PositionTab)->setPicture(m_legend.position);
            tabChanged();
        },
        [this](const QString& why) { viewer(PositionTab)->setPlaceholder(why); });
}

ImageViewer* ResultView::currentViewer() const {
    const int index = m_tabs->currentIndex();
    if (index < static_cast<int>(m_viewers.size()))
        return m_viewers[static_cast<std::size_t>(index)];
    const QList<ImageViewer*> viewers = m_tabs->currentWidget()->findChildren<ImageViewer*>();
    for (ImageViewer* inPage : viewers)
        if (inPage->hasFocus())
            return inPage;
    return viewers.isEmpty() ? viewer(ResultTab) : viewers.front();
}

void ResultView::addPage(QWidget* page, const QString& title, const QString& toolTip) {
    m_tabs->setTabToolTip(m_tabs->addTab(page, title), toolTip);
}

void ResultView::setPageOffered(QWidget* page, bool offered) {
    m_tabs->setTabVisible(m_tabs->indexOf(page), offered);
}

bool ResultView::pageOffered(QWidget* page) const {
    return m_tabs->isTabVisible(m_tabs->indexOf(page));
}

void ResultView::showPage(QWidget* page) {
    m_tabs->setCurrentWidget(page);
}

void ResultView::setNotes(const QStringList& notes) {
    if (notes.isEmpty())
        m_notes->dismiss();
    else
        m_notes->say(MessageBar::Kind::Information, notes.join(QLatin1Char('\n')));
}

QString ResultView::notes() const {
    return m_notes->text();
}

void ResultView::setTab(Tab tab) {
    m_tabs->setCurrentIndex(tab);
}

void ResultView::markPosition(const ExemplarEntry* entry, QPoint pixel) {
    if (entry != nullptr && entry->id == m_exemplar)
        viewer(PositionTab)->setMarker(pixel);
    else
        viewer(PositionTab)->setMarker({});
}

void ResultView::setRepeats(bool repeat) {
    for (ImageViewer* shown : m_viewers)
        shown->setRepeats(repeat);
}

} // namespace texloom::ui
