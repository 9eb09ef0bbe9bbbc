#pragma once

#include <QWidget>

class QPlainTextEdit;

namespace texloom::ui {

/// The Log dock: what happened, with the time, to be read and copied.
class LogPanel : public QWidget {
    Q_OBJECT

public:
    explicit LogPanel(QWidget* parent = nullptr);

    /// Adds a line. The oldest go when there are very many.
    void add(const QString& text);
    QString text() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void scrollToEnd();

    QPlainTextEdit* m_text;
};

} // namespace texloom::ui
