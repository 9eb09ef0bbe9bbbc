#include "ui/viewers/result_view.h"

#include "core/analysis/map_pictures.h"
#include "ui/jobs/background.h"
#include "ui/window/elided_label.h"

#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

#include <utility>

namespace texloom::ui {

ResultView::ResultView(QWidget* parent)
    : QWidget(parent), m_title(new ElidedLabel(this)), m_tabs(new QTabWidget(this)) {
    m_title->setObjectName(QStringLiteral("resultTitle"));
    m_tabs->setObjectName(QStringLiteral("resultTabs"));
    m_tabs->setDocumentMode(true);
    m_viewers = {addViewer(QStringLiteral("resultViewer"), tr("Result")),
                 addViewer(QStringLiteral("synthesisViewer"), tr("Synthesis map")),
                 addViewer(QStringLiteral("positionViewer"), tr("Position map"))};
    m_tabs->setTabToolTip(SynthesisTab,
                          tr("Every pixel in the colour that the position map gives its source: even "
                             "areas are copied as they are."));
    m_tabs->setTabToolTip(PositionTab,
                          tr("The legend of the synthesis map: a colour for every pixel of the exemplar."));
    share(viewer(ResultTab), viewer(SynthesisTab));
    share(viewer(SynthesisTab), viewer(ResultTab));
    for (const Tab tab : {ResultTab, SynthesisTab})
        connect(viewer(tab), &ImageViewer::hovered, this, &ResultView::resultHovered);
    connect(viewer(PositionTab), &ImageViewer::hovered, this, &ResultView::positionHovered);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_title);
    column->addWidget(m_tabs, 1);
    viewer(ResultTab)->setPlaceholder(tr("No result yet. Press Run."));
    viewer(PositionTab)->setPlaceholder(tr("Open an exemplar to see its position map."));
    explainMaps();
}

ImageViewer* ResultView::addViewer(const QString& name, const QString& title) {
    auto* viewer = new ImageViewer(m_tabs);
    viewer->setObjectName(name);
    viewer->setAccessibleName(title);
    m_tabs->addTab(viewer, title);
    connect(viewer, &ImageViewer::unhovered, this, &ResultView::unhovered);
    return viewer;
}

void ResultView::share(ImageViewer* from, ImageViewer* to) {
    connect(from, &ImageViewer::viewChanged, to, [from, to] {
        const QSignalBlocker blocker(to);
        if (from->picture() && to->picture() && from->picture()->size() == to->picture()->size())
            to->setView(from->view(), from->fitted());
    });
}

void ResultView::showPictures(const RunPictures& pictures) {
    m_pictures = pictures;
    viewer(ResultTab)->setPicture(pictures.result);
    viewer(SynthesisTab)->setPicture(pictures.synthesis);
    viewer(SynthesisTab)->setView(viewer(ResultTab)->view(), viewer(ResultTab)->fitted());
    explainMaps();
}

void ResultView::explainMaps() {
    viewer(SynthesisTab)
        ->setPlaceholder(m_pictures.result
                             ? tr("This method makes new pixels and copies none,\nso there is no map of "
                                  "where they came from.")
                             : tr("No result yet. The map shows where each of its pixels came from."));
}

void ResultView::setTitle(const QString& text) {
    m_title->setFullText(text);
}

QString ResultView::title() const {
    return m_title->fullText();
}

void ResultView::setBadge(const QString& text) {
    for (const Tab tab : {ResultTab, SynthesisTab})
        viewer(tab)->setBadge(text);
}

void ResultView::setExemplar(const ExemplarEntry* entry, int index, int count) {
    const int request = ++m_request;
    m_exemplar = entry != nullptr ? entry->id : 0;
    if (entry == nullptr) {
        viewer(PositionTab)->setPicture(nullptr);
        return;
    }
    const auto make = [size = entry->file().image->size(), index, count] {
        return std::make_shared<const DisplayPicture>(
            std::make_shared<const Image>(positionPicture(size, index, count)));
    };
    inBackground(
        this, make,
        [this, request](std::shared_ptr<const DisplayPicture> picture) {
            if (request == m_request)
                viewer(PositionTab)->setPicture(std::move(picture));
        },
        [this](const QString& why) { viewer(PositionTab)->setPlaceholder(why); });
}

ImageViewer* ResultView::currentViewer() const {
    auto* const front = qobject_cast<ImageViewer*>(m_tabs->currentWidget());
    return front != nullptr ? front : viewer(ResultTab);
}

void ResultView::addPage(QWidget* page, const QString& title, const QString& toolTip) {
    m_tabs->setTabToolTip(m_tabs->addTab(page, title), toolTip);
}

void ResultView::showPage(QWidget* page) {
    m_tabs->setCurrentWidget(page);
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
