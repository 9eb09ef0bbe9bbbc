#pragma once

#include <QPointF>
#include <QString>
#include <QWidget>

#include <vector>

class QChart;
class QChartView;
class QStackedWidget;
class QTableWidget;
class QToolButton;

namespace texloom::ui {

/// One line of a plot.
struct PlotSeries {
    QString name;
    std::vector<QPointF> points; ///< by rising x
};

/// Everything that a plot shows.
struct PlotData {
    QString title;
    QString xTitle, yTitle;
    std::vector<PlotSeries> series;
    bool logarithmicX = false; ///< x must be positive
    bool points = false;       ///< marks each point

    bool empty() const { return series.empty(); }
};

/// Series over one axis, in the colours of the window and told apart by dashes as well. The numbers can be
/// read in a table in its place, and copied.
class Plot : public QWidget {
    Q_OBJECT

public:
    explicit Plot(QWidget* parent = nullptr);

    void setData(const PlotData& data);
    const PlotData& data() const { return m_data; }
    /// Shows the table in place of the picture.
    void setNumbers(bool numbers);
    /// One row for every x, one column for every series; missing values are empty.
    QString csv() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        double x = 0;
        std::vector<QString> values;
    };

    std::vector<Row> rows() const;
    void draw();
    void fillTable();
    void colorChart(QChart* chart) const;

    PlotData m_data;
    QStackedWidget* m_stack;
    QChartView* m_view;
    QTableWidget* m_table;
    QToolButton* m_numbers;
    QToolButton* m_copy;
};

} // namespace texloom::ui
