#include "ui/window/run_notice.h"

#include "ui/runs/run_desk.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace texloom::ui {

namespace {

/// org.freedesktop.Notifications, the desktops' common interface.
void postByDBus(const QString& title, const QString& text) {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected())
        return;
    const QString service = QStringLiteral("org.freedesktop.Notifications");
    QDBusMessage call = QDBusMessage::createMethodCall(
        service, QStringLiteral("/org/freedesktop/Notifications"), service, QStringLiteral("Notify"));
    constexpr uint kNew = 0;
    constexpr int kUsualTime = -1;
    call << QApplication::applicationDisplayName() << kNew << QApplication::desktopFileName() << title << text
         << QStringList() << QVariantMap() << kUsualTime;
    bus.send(call);
}

/// com.canonical.Unity.LauncherEntry, which the task bars of Plasma, Unity and docks of GNOME listen to.
void showInTaskBar(int percent) {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected())
        return;
    QDBusMessage signal = QDBusMessage::createSignal(QStringLiteral("/io/github/texloom/Texloom"),
                                                     QStringLiteral("com.canonical.Unity.LauncherEntry"),
                                                     QStringLiteral("Update"));
    signal << QStringLiteral("application://%1.desktop").arg(QApplication::desktopFileName())
           << QVariantMap{{QStringLiteral("progress"), std::max(0, percent) / 100.0},
                          {QStringLiteral("progress-visible"), percent >= 0}};
    bus.send(signal);
}

} // namespace

RunNotice::RunNotice(RunDesk* desk, QWidget* window)
    : QObject(window), m_desk(desk), m_window(window), m_post(postByDBus) {
    connect(desk, &RunDesk::kept, this,
            [this](const QueuedJob& job, const std::string&, const RunPictures& pictures) {
                tell(job, pictures.run->seconds, tr("Finished"));
            });
    connect(desk->queue(), &JobQueue::failed, this,
            [this](const QueuedJob& job) { tell(job, job.progress.seconds, tr("Failed")); });
    connect(desk->queue(), &JobQueue::progressed, this, &RunNotice::showProgress);
    connect(desk->queue(), &JobQueue::changed, this, &RunNotice::showProgress);
}

void RunNotice::tell(const QueuedJob& job, double seconds, const QString& title) {
    if (seconds < kLong || m_window->isActiveWindow())
        return;
    QApplication::alert(m_window);
    m_post(title, job.problem.isEmpty() ? job.label : tr("%1: %2").arg(job.label, job.problem));
}

void RunNotice::showProgress() {
    const QueuedJob* const job = m_desk->queue()->current();
    const int percent = job != nullptr ? static_cast<int>(std::floor(100 * job->progress.fraction)) : -1;
    if (percent == m_percent)
        return;
    m_percent = percent;
    showInTaskBar(percent);
}

} // namespace texloom::ui
