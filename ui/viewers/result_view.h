#pragma once

#include "ui/exemplar/exemplar_store.h"
#include "ui/jobs/run_pictures.h"
#include "ui/viewers/image_viewer.h"

#include <QPoint>
#include <QWidget>

#include <array>
#include <memory>

class QTabWidget;

namespace texloom::ui {

class ElidedLabel;

/// The middle of the window: the result, its synthesis map and the exemplar's position map in tabs that share
/// what they look at, under a line that says what is shown.
class ResultView : public QWidget {
    Q_OBJECT

public:
    enum Tab { ResultTab, SynthesisTab, PositionTab };

    explicit ResultView(QWidget* parent = nullptr);

    /// Shows a run's pictures, under way or finished.
    void showPictures(const RunPictures& pictures);
    const RunPictures& pictures() const { return m_pictures; }
    /// The line above the tabs.
    void setTitle(const QString& text);
    QString title() const;
    /// A short text over the result, such as "Quick preview".
    void setBadge(const QString& text);
    /// The exemplar whose position map is shown, and its place among those of the run, for its hues.
    void setExemplar(const ExemplarEntry* entry, int index, int count);

    /// Adds a tab of another kind behind the others. It stays the caller's to fill.
    void addPage(QWidget* page, const QString& title, const QString& toolTip);
    /// Brings a page that was added to the front.
    void showPage(QWidget* page);

    ImageViewer* viewer(Tab tab) const { return m_viewers[static_cast<std::size_t>(tab)]; }
    /// The viewer of the tab in front; that of the result if a page without one is.
    ImageViewer* currentViewer() const;
    void setTab(Tab tab);
    /// Marks a pixel in the position map; takes the mark away if it belongs to another exemplar.
    void markPosition(const ExemplarEntry* entry, QPoint pixel);

public Q_SLOTS:
    /// Shows every picture tiled without end.
    void setRepeats(bool repeat);

Q_SIGNALS:
    /// The cursor is over a pixel of the result or its synthesis map.
    void resultHovered(QPoint pixel);
    /// The cursor is over a pixel of the exemplar, in its position map.
    void positionHovered(QPoint pixel);
    void unhovered();

private:
    ImageViewer* addViewer(const QString& name, const QString& title);
    void share(ImageViewer* from, ImageViewer* to);
    void explainMaps();

    ElidedLabel* m_title;
    QTabWidget* m_tabs;
    std::array<ImageViewer*, 3> m_viewers{};
    RunPictures m_pictures;
    int m_exemplar = 0;
    int m_request = 0;
};

} // namespace texloom::ui
