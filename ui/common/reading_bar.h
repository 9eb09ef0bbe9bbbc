#pragma once

#include <QFrame>
#include <QTimer>

namespace texloom::ui {

class ElidedLabel;

/// Says which file is being read or edited, once that takes longer than a moment, and offers to break it off.
class ReadingBar : public QFrame {
    Q_OBJECT

public:
    explicit ReadingBar(QWidget* parent = nullptr);

private:
    void refresh();

    ElidedLabel* m_text;
    QTimer m_patience;
};

} // namespace texloom::ui
