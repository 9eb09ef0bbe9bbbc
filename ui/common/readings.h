#pragma once

#include "ui/common/background.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texloom::ui {

/// The files that are being read or edited, so that the window can say so and the user can break it off. Used
/// on the GUI thread.
class Readings : public QObject {
    Q_OBJECT

public:
    enum class Doing { Read, Edit };

    /// One of them.
    struct Reading {
        Reading(QString name, Doing work) : what(std::move(name)), doing(work) {}
        const QString what; ///< the file's name
        const Doing doing;
        std::atomic<bool> stopped = false; ///< by the user
        std::atomic<bool> over = false;    ///< set on the worker
    };

    /// Those of this program.
    static Readings& all();

    std::shared_ptr<Reading> begin(const QString& what, Doing doing = Doing::Read);
    void end(const std::shared_ptr<Reading>& reading);
    /// What has been under way for longest; null if nothing is.
    std::shared_ptr<const Reading> first() const;
    int count() const { return static_cast<int>(m_readings.size()); }
    /// Breaks off all of them.
    void stop();

Q_SIGNALS:
    void changed();

private:
    std::vector<std::shared_ptr<Reading>> m_readings;
};

/// Calls `work` on a worker. Once the reading is stopped, what is being decoded in it ends at once, and
/// nothing more is. @return whether it came to its end.
bool cameToEnd(Readings::Reading& reading, const std::function<void()>& work);

/// inBackground() for work that reads or edits files, which the user can break off; work that takes long
/// calls DecoderProcess::check() for that.
/// @param what the file's name. @param failed gets an empty text where it was broken off. @return by which it
/// can be broken off, too.
template <class Work, class Done, class Failed>
std::shared_ptr<Readings::Reading> readInBackground(QObject* context, const QString& what, Work work,
                                                    Done done, Failed failed,
                                                    Readings::Doing doing = Readings::Doing::Read) {
    std::shared_ptr<Readings::Reading> reading = Readings::all().begin(what, doing);
    inBackground(
        context,
        [reading, work = std::move(work)]() mutable {
            std::optional<std::invoke_result_t<Work>> result;
            return cameToEnd(*reading, [&] { result.emplace(work()); }) ? std::move(result) : std::nullopt;
        },
        [reading, done = std::move(done), failed](auto result) mutable {
            Readings::all().end(reading);
            if (result)
                done(std::move(*result));
            else
                failed(QString());
        },
        [reading, failed](const QString& why) mutable {
            Readings::all().end(reading);
            failed(why);
        });
    return reading;
}

} // namespace texloom::ui
