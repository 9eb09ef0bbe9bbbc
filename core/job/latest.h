#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace texloom {

/// Hands the newest value from a worker to whoever looks: the worker leaves it, the reader takes it on a
/// timer. A value that nobody took is replaced; neither side ever waits for the other.
template <class T> class Latest {
public:
    /// Leaves a value, in place of one not yet taken.
    void put(T value) {
        std::optional<T> fresh(std::move(value));
        const std::lock_guard lock(m_mutex);
        m_value.swap(fresh);
    }

    /// The newest value not yet taken, if there is one.
    std::optional<T> take() {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }

    /// Whether the last value put has not been taken yet.
    bool waiting() const {
        const std::lock_guard lock(m_mutex);
        return m_value.has_value();
    }

private:
    mutable std::mutex m_mutex;
    std::optional<T> m_value;
};

} // namespace texloom
