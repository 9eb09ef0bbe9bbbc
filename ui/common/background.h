#pragma once

#include <QCoreApplication>
#include <QMetaObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>

#include <exception>
#include <memory>
#include <type_traits>
#include <utility>

namespace texloom::ui {

/// The threads for short work beside a run: loading, writing, making pictures. Empty it with waitForDone()
/// before the application object goes.
QThreadPool& workers();

/// The sentence that an exception has for the user.
QString sentence(const std::exception& error);

/// Calls `work` on a thread of `pool` and then, on the GUI thread, `done` with its result, or `failed` with a
/// sentence if it threw. Neither is called if `context` is gone by then.
template <class Work, class Done, class Failed>
void inBackground(QThreadPool& pool, QObject* context, Work work, Done done, Failed failed) {
    using Result = std::invoke_result_t<Work>;
    pool.start([guard = QPointer<QObject>(context), work = std::move(work), done = std::move(done),
                failed = std::move(failed)]() mutable {
        std::shared_ptr<Result> result;
        QString error;
        try {
            result = std::make_shared<Result>(work());
        } catch (const std::exception& thrown) {
            error = sentence(thrown);
        }
        const auto deliver = [guard, result, error, done = std::move(done),
                              failed = std::move(failed)]() mutable {
            if (!guard)
                return;
            if (result)
                done(std::move(*result));
            else
                failed(error);
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), deliver, Qt::QueuedConnection);
    });
}

/// The same on one of the workers().
template <class Work, class Done, class Failed>
void inBackground(QObject* context, Work work, Done done, Failed failed) {
    inBackground(workers(), context, std::move(work), std::move(done), std::move(failed));
}

} // namespace texloom::ui
