#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace texloom::test {

/// Bytes by which the resident set grew at its peak while `work` ran; nothing where the kernel does not allow
/// the peak to be reset.
std::optional<std::uint64_t> peakGrowth(const std::function<void()>& work);

/// Whether this build carries a sanitizer, whose own memory and time would spoil such figures.
constexpr bool kSanitized =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

} // namespace texloom::test
