#include "ui/common/readings.h"

#include "core/io/decoder_process.h"
#include "core/job/job_context.h"

#include <algorithm>

namespace texloom::ui {

Readings& Readings::all() {
    static Readings readings;
    return readings;
}

std::shared_ptr<Readings::Reading> Readings::begin(const QString& what, Doing doing) {
    // Nobody ends those whose window is gone.
    std::erase_if(m_readings, [](const auto& reading) { return reading->over.load(); });
    m_readings.push_back(std::make_shared<Reading>(what, doing));
    Q_EMIT changed();
    return m_readings.back();
}

void Readings::end(const std::shared_ptr<Reading>& reading) {
    std::erase(m_readings, reading);
    Q_EMIT changed();
}

std::shared_ptr<const Readings::Reading> Readings::first() const {
    return m_readings.empty() ? nullptr : m_readings.front();
}

void Readings::stop() {
    for (const std::shared_ptr<Reading>& reading : m_readings)
        reading->stopped = true;
}

bool cameToEnd(Readings::Reading& reading, const std::function<void()>& work) {
    const DecoderProcess::Watch watch([&reading] {
        if (reading.stopped)
            throw Cancelled{};
    });
    try {
        DecoderProcess::check();
        work();
    } catch (const Cancelled&) {
        reading.over = true;
        return false;
    } catch (...) {
        reading.over = true;
        throw;
    }
    reading.over = true;
    return true;
}

} // namespace texloom::ui
