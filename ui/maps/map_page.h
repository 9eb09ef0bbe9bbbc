#pragma once

#include <QWidget>

#include <functional>

class QLabel;
class QPushButton;

namespace texloom::ui {

class ImageViewer;
class TaskBar;

/// A tab with a map of the result, and a line under it that says how far it can be trusted.
class MapPage : public QWidget {
    Q_OBJECT

public:
    explicit MapPage(const QString& name, QWidget* parent = nullptr);

    ImageViewer* viewer() const { return m_viewer; }
    /// The line under the picture; none if empty.
    void setLine(const QString& text);
    QString line() const;
    /// Offers to estimate a map that is not there.
    void setOffer(bool offered);
    /// Shows how far the estimation is; an empty function ends that.
    void setProgress(const std::function<double()>& progress);

Q_SIGNALS:
    void estimateWanted();
    void cancelled();

private:
    ImageViewer* m_viewer;
    QLabel* m_line;
    QPushButton* m_estimate;
    TaskBar* m_bar;
};

} // namespace texloom::ui
