#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <utility>

class QWidget;

namespace texloom::ui {

class RunDesk;
struct QueuedJob;

/// Tells someone who looks elsewhere how long runs go: the task bar shows how far one is, and the desktop
/// says when it has ended. Both by D-Bus, and nothing where there is no session bus.
class RunNotice : public QObject {
    Q_OBJECT

public:
    /// What hands a notice to the desktop.
    using Post = std::function<void(const QString& title, const QString& text)>;

    /// Runs that took less than this many seconds are not worth a notice.
    static constexpr double kLong = 15;

    RunNotice(RunDesk* desk, QWidget* window);
    void setPost(Post post) { m_post = std::move(post); }

private:
    void tell(const QueuedJob& job, double seconds, const QString& title);
    void showProgress();

    RunDesk* m_desk;
    QWidget* m_window;
    Post m_post;
    int m_percent = -1; ///< that the task bar shows; −1 for none
};

} // namespace texloom::ui
