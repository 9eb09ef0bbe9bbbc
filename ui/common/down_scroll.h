#pragma once

#include <QScrollArea>

namespace texloom::ui {

/// Scrolls down only: it is always wide enough for its content, however that changes.
class DownScroll : public QScrollArea {
    Q_OBJECT

public:
    explicit DownScroll(QWidget* content, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fit();
};

} // namespace texloom::ui
