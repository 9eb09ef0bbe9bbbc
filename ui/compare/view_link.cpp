#include "ui/compare/view_link.h"

#include <algorithm>

namespace texloom::ui {

ViewLink::Sight ViewLink::sightOf(ImageViewer* viewer) {
    const QPointF middle = QRectF(viewer->rect()).center();
    return {viewer, viewer->view().scale(), viewer->view().toImage(middle)};
}

void ViewLink::add(ImageViewer* viewer) {
    m_sights.push_back(sightOf(viewer));
    connect(viewer, &ImageViewer::viewChanged, this, [this, viewer] { follow(viewer); });
    connect(viewer, &ImageViewer::viewSettled, this, [this, viewer] { note(viewer); });
    connect(viewer, &ImageViewer::repeatsChanged, this,
            [this, viewer](bool repeat) { repeatAll(viewer, repeat); });
}

void ViewLink::clear() {
    for (const Sight& sight : m_sights)
        sight.viewer->disconnect(this);
    m_sights.clear();
}

void ViewLink::note(const ImageViewer* viewer) {
    for (Sight& sight : m_sights)
        if (sight.viewer == viewer)
            sight = sightOf(sight.viewer);
}

void ViewLink::follow(ImageViewer* moved) {
    if (m_following)
        return;
    const auto before = std::find_if(m_sights.begin(), m_sights.end(),
                                     [moved](const Sight& sight) { return sight.viewer == moved; });
    const Sight after = sightOf(moved);
    const double ratio = after.scale / before->scale;
    const QPointF shift = after.centre - before->centre;
    *before = after;
    if (!m_linked)
        return;
    m_following = true;
    for (Sight& sight : m_sights) {
        if (sight.viewer == moved)
            continue;
        ViewTransform view = sight.viewer->view();
        view.setScaleAt(QRectF(sight.viewer->rect()).center(), view.scale() * ratio);
        view.pan(-shift * view.scale());
        sight.viewer->setView(view, moved->fitted());
        sight = sightOf(sight.viewer);
    }
    m_following = false;
}

void ViewLink::repeatAll(const ImageViewer* changed, bool repeat) {
    if (!m_linked || m_following)
        return;
    m_following = true;
    for (Sight& sight : m_sights)
        if (sight.viewer != changed) {
            sight.viewer->setRepeats(repeat);
            sight = sightOf(sight.viewer);
        }
    m_following = false;
}

} // namespace texloom::ui
