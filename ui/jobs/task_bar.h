#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace texloom::ui {

/// A line that shows how far a piece of background work is and calls it off; hidden while there is none.
class TaskBar : public QWidget {
    Q_OBJECT

public:
    explicit TaskBar(QWidget* parent = nullptr);

    /// @param progress asked on a timer: 0 to 1.
    void begin(const QString& text, std::function<double()> progress);
    void end();

Q_SIGNALS:
    void cancelled();

private:
    void poll();

    QLabel* m_text;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    QTimer m_timer;
    std::function<double()> m_progress;
};

} // namespace texloom::ui
