#pragma once

#include "ui/exemplar/exemplar_store.h"
#include "ui/runs/run_pictures.h"
#include "ui/viewers/image_viewer.h"

#include <QPoint>
#include <QWidget>

#include <array>
#include <memory>

class QPushButton;
class QTabWidget;

namespace texloom::ui {

class ElidedLabel;
class MapPage;
class MessageBar;
class ResultMaps;

/// The middle of the window: the result, its synthesis map and the exemplar's position map in tabs that share
/// what they look at, under a line that says what is shown. Workspaces stand in further tabs.
class ResultView : public QWidget {
    Q_OBJECT

public:
    enum Tab { ResultTab, SynthesisTab, PositionTab, CopiesTab };

    explicit ResultView(QWidget* parent = nullptr);

    /// Shows a run's pictures, under way or finished.
    void showPictures(const RunPictures& pictures);
    /// What is shown, with the map that was estimated if one was.
    const RunPictures& pictures() const;
    /// The line above the tabs.
    void setTitle(const QString& text);
    /// Buttons beside it: that the result does not wrap, and how to make it wrap; that its exemplar was
    /// edited since, and how to run it again.
    void setOffers(bool wrap, bool rerun);
    QString title() const;
    /// A short text over the result, such as "Quick preview".
    void setBadge(const QString& text);
    /// The exemplar whose position map is shown, and its place among those of the run, for its hues.
    void setExemplar(const ExemplarEntry* entry, int index, int count);

    /// Adds a tab of another kind behind the others. It stays the caller's to fill.
    void addPage(QWidget* page, const QString& title, const QString& toolTip);
    /// Whether the tab of a page that was added is there to be chosen; it is at first.
    void setPageOffered(QWidget* page, bool offered);
    bool pageOffered(QWidget* page) const;
    /// Brings a page that was added to the front.
    void showPage(QWidget* page);

    ImageViewer* viewer(Tab tab) const { return m_viewers[static_cast<std::size_t>(tab)]; }
    /// The viewer of the tab in front; in a page with several the one with the focus, or the first; that of
    /// the result if a page without one is.
    ImageViewer* currentViewer() const;
    /// Sentences about the result, in place until they are closed; none takes them away.
    void setNotes(const QStringList& notes);
    QString notes() const;
    void setTab(Tab tab);
    /// Marks a pixel in the position map; takes the mark away if it belongs to another exemplar.
    void markPosition(const ExemplarEntry* entry, QPoint pixel);
    /// Rings the copies of an exemplar's pixel. @return their number; 0 also while it is not known.
    std::size_t showCopies(const Source& source);
    void hideCopies();
    /// What the line under a map says of it; empty where there is no map.
    QString mapLine(Tab tab) const;

public Q_SLOTS:
    /// Shows every picture tiled without end.
    void setRepeats(bool repeat);

Q_SIGNALS:
    /// Another tab came to the front.
    void tabShown();
    void wrapWanted();
    void rerunWanted();
    /// The cursor is over a pixel of the result or its synthesis map.
    void resultHovered(QPoint pixel);
    /// The cursor is over a pixel of the exemplar, in its position map.
    void positionHovered(QPoint pixel);
    void unhovered();
    /// While a map is in front: the exemplar in the position map's colours. Else null.
    void legendChanged(std::shared_ptr<const texloom::ui::DisplayPicture> legend);

private:
    struct Legend {
        std::shared_ptr<const DisplayPicture> position, over;
    };

    QLayout* makeTitleRow();
    ImageViewer* addViewer(ImageViewer* viewer, QWidget* page, const QString& title);
    MapPage* addMap(const QString& name, const QString& title);
    void connectMaps();
    void showMapPictures();
    void showCopiesPicture();
    void tabChanged();
    void share(ImageViewer* from, ImageViewer* to);
    void explainMaps();

    ElidedLabel* m_title;
    QPushButton* m_wrapOffer;
    QPushButton* m_rerunOffer;
    MessageBar* m_notes;
    QTabWidget* m_tabs;
    ResultMaps* m_maps;
    std::array<ImageViewer*, 4> m_viewers{};
    MapPage* m_synthesis = nullptr;
    MapPage* m_copies = nullptr;
    QString m_runBadge;
    Legend m_legend;
    int m_exemplar = 0;
    int m_request = 0;
};

} // namespace texloom::ui
