#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace texloom::test {

/// How many times longer work takes than it would with all cores to itself: 1 on a machine that does nothing
/// else. Measured for a few hundredths of a second on every core.
double slowness();

/// A time limit that is promised for a machine to itself, as it holds here and now: longer where others
/// compute as well, ten times as long under a sanitizer, and none where the machine is so busy that times say
/// nothing.
std::optional<std::chrono::milliseconds> limitNow(std::chrono::milliseconds alone);

/// Why there is no limit, for GTEST_SKIP().
inline constexpr const char* kTooBusy =
    "skipped: this machine is more than five times slower than alone; times say nothing on it";

/// Time that passes, as this process would see it alone on the machine.
class Stopwatch {
public:
    Stopwatch();
    /// Time since it was made, but no more than all threads of this process computed meanwhile: while they do
    /// nothing, others have the cores. A tenth of the whole counts in any case, so that waiting for nothing
    /// shows as well.
    std::chrono::nanoseconds alone() const;

private:
    std::chrono::steady_clock::time_point m_begun;
    std::chrono::nanoseconds m_computed;
};

/// The shortest of up to five times that `measure` returns, the first within `limit` ending it: whoever else
/// computes may take a core at any moment.
std::chrono::nanoseconds shortest(std::chrono::milliseconds limit,
                                  const std::function<std::chrono::nanoseconds()>& measure);

} // namespace texloom::test
