#include "tests/support/time_limit.h"

#include <algorithm>
#include <ctime>
#include <thread>
#include <vector>

namespace texloom::test {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr double kMostSlowness = 5;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kSanitizer = 10;
#else
constexpr int kSanitizer = 1;
#endif

std::chrono::nanoseconds computed(clockid_t whose) {
    timespec spent{};
    ::clock_gettime(whose, &spent);
    return std::chrono::seconds(spent.tv_sec) + std::chrono::nanoseconds(spent.tv_nsec);
}

/// Time that passes while this thread computes for a while, by that while.
double passed() {
    constexpr std::chrono::nanoseconds kWork = 30ms;
    const auto begun = Clock::now();
    const std::chrono::nanoseconds before = computed(CLOCK_THREAD_CPUTIME_ID);
    while (computed(CLOCK_THREAD_CPUTIME_ID) - before < kWork) {}
    return std::chrono::duration<double>(Clock::now() - begun) / std::chrono::duration<double>(kWork);
}

} // namespace

double slowness() {
    std::vector<double> each(std::max(1U, std::thread::hardware_concurrency()), 1);
    {
        std::vector<std::jthread> threads;
        for (double& one : each)
            threads.emplace_back([&one] { one = passed(); });
    }
    return *std::max_element(each.begin(), each.end());
}

std::optional<std::chrono::milliseconds> limitNow(std::chrono::milliseconds alone) {
    const double now = slowness();
    if (now > kMostSlowness)
        return std::nullopt;
    return std::chrono::milliseconds(static_cast<int>(static_cast<double>(alone.count()) * kSanitizer * now));
}

Stopwatch::Stopwatch() : m_begun(Clock::now()), m_computed(computed(CLOCK_PROCESS_CPUTIME_ID)) {}

std::chrono::nanoseconds Stopwatch::alone() const {
    const std::chrono::nanoseconds passed = Clock::now() - m_begun;
    return std::max(std::min(passed, computed(CLOCK_PROCESS_CPUTIME_ID) - m_computed), passed / 10);
}

std::chrono::nanoseconds shortest(std::chrono::milliseconds limit,
                                  const std::function<std::chrono::nanoseconds()>& measure) {
    std::chrono::nanoseconds best = measure();
    for (int again = 0; again < 4 && best > limit; ++again)
        best = std::min(best, measure());
    return best;
}

} // namespace texloom::test
