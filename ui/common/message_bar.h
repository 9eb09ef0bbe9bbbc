#pragma once

#include <QFrame>
#include <QTimer>

#include <functional>

class QLabel;
class QPushButton;

namespace texloom::ui {

/// Says what happened in place, above what it is about, and never stops anyone's work: what, why, what to do.
/// The newest message replaces the one before.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Information, Error };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Shows a message. @param action the label of a button that offers something to do about it; none if
    /// empty.
    void say(Kind kind, const QString& text, const QString& action = {}, std::function<void()> onAction = {});
    /// Says what is over as soon as it is read: it leaves by itself.
    void sayBriefly(const QString& text);
    void dismiss();
    /// The same unless it offers something that can still be done.
    void dismissTold();
    /// The same if it is this text that is shown: what it was about is over.
    void dismiss(const QString& text);
    /// The message shown; empty if there is none.
    QString text() const;
    Kind kind() const { return m_kind; }

private:
    Kind m_kind = Kind::Information;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_action;
    std::function<void()> m_onAction;
    QTimer m_brief;
};

} // namespace texloom::ui
