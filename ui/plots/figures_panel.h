#pragma once

#include "core/session/run/run.h"
#include "ui/jobs/task.h"
#include "ui/picture/display_picture.h"
#include "ui/plots/plot.h"

#include <QWidget>

#include <memory>
#include <variant>
#include <vector>

class QLabel;
class QListWidget;
class QStackedWidget;
class QTableWidget;

namespace texloom::ui {

class ImageViewer;
class TaskBar;

/// The dock of figures about a result: its numbers, colours and patches beside the exemplar's, the curves and
/// pictures that its method made, and how both repeat themselves. Made in the background, only while it is
/// seen.
class FiguresPanel : public QWidget {
    Q_OBJECT

public:
    explicit FiguresPanel(QWidget* parent = nullptr);

    /// The result that it is about; null for none.
    void setResult(std::shared_ptr<const Result> result);
    /// Curves of a run under way, in place of all that is shown, until the next result.
    void showCurves(const std::vector<texloom::Curve>& curves);
    /// Titles of the figures there are, in order.
    QStringList titles() const;
    void showFigure(const QString& title);
    Plot* plot() const { return m_plot; }
    ImageViewer* viewer() const { return m_viewer; }

    /// Whether anyone can see it: a dock behind other tabs is not hidden, but not seen either.
    void setSeen(bool seen);

private:
    /// A named number as it is shown.
    struct Number {
        QString name, value;
    };
    struct Entry {
        QString title;
        std::variant<PlotData, std::shared_ptr<const DisplayPicture>, std::vector<Number>> content;
    };

    static std::vector<Entry> entriesOf(const Result& result, JobContext& context);
    static void addHistograms(const Result& result, std::vector<Entry>& entries, JobContext& context);
    static void addUse(const Result& result, std::vector<Entry>& entries, JobContext& context);
    static void addCorrelations(const Result& result, std::vector<Entry>& entries, JobContext& context);
    /// What else the last method made, as far as it can be looked at here.
    static void addOutputs(const Result& result, std::vector<Entry>& entries);
    static std::vector<Number> numbersOf(const Model& model);
    void begin();
    void drawCurves();
    void take(std::vector<Entry> entries);
    void showEntry(int row);

    bool m_seen = false;
    std::shared_ptr<const Result> m_result;
    std::shared_ptr<const Result> m_made; ///< the result that the entries are of
    std::vector<Curve> m_curves;          ///< of the run under way; empty if there is none
    std::vector<Entry> m_entries;
    QListWidget* m_list;
    QStackedWidget* m_stack;
    QLabel* m_hint;
    Plot* m_plot;
    ImageViewer* m_viewer;
    QTableWidget* m_table;
    TaskBar* m_bar;
    Task<std::vector<Entry>> m_task;
};

} // namespace texloom::ui
