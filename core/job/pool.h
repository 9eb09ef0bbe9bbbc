#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace texloom {

/// Working memory that is lent to whoever works at the moment, so that no more of it is made than there are
/// threads at work. May be used from any thread.
template <class T> class Pool {
    struct GiveBack {
        Pool* pool;
        void operator()(T* object) const { pool->giveBack(std::unique_ptr<T>(object)); }
    };

public:
    /// Goes back to the pool, which must outlive it.
    using Loan = std::unique_ptr<T, GiveBack>;

    /// An idle object, or a new one that `make` returns.
    template <class Make> Loan borrow(const Make& make) {
        std::unique_ptr<T> object = idle();
        if (!object)
            object = std::make_unique<T>(make());
        return Loan(object.release(), GiveBack{this});
    }

private:
    std::unique_ptr<T> idle() {
        const std::lock_guard lock(m_mutex);
        if (m_idle.empty())
            return nullptr;
        std::unique_ptr<T> object = std::move(m_idle.back());
        m_idle.pop_back();
        return object;
    }
    void giveBack(std::unique_ptr<T> object) {
        const std::lock_guard lock(m_mutex);
        m_idle.push_back(std::move(object));
    }

    std::mutex m_mutex;
    std::vector<std::unique_ptr<T>> m_idle;
};

} // namespace texloom
