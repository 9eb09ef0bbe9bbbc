#pragma once

#include "ui/viewers/image_viewer.h"

#include <QObject>
#include <QPointF>

#include <vector>

namespace texloom::ui {

/// Makes viewers move together: what is zoomed or panned in one is so in all, each from where it is. Those
/// that were moved apart while the link was off stay apart by as much when it is on again.
class ViewLink : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void add(ImageViewer* viewer);
    void clear();
    bool linked() const { return m_linked; }
    void setLinked(bool linked) { m_linked = linked; }

private:
    /// What a viewer shows, whatever its size in the window.
    struct Sight {
        ImageViewer* viewer;
        double scale;
        QPointF centre; ///< image point in the viewer's middle
    };

    static Sight sightOf(ImageViewer* viewer);
    void note(const ImageViewer* viewer);
    void follow(ImageViewer* moved);
    void repeatAll(const ImageViewer* changed, bool repeat);

    std::vector<Sight> m_sights;
    bool m_linked = true;
    bool m_following = false;
};

} // namespace texloom::ui
