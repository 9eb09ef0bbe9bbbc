#pragma once

#include <cstdint>
#include <span>

namespace texloom::test {

/// FNV-1a over 64 bits, for values that must not change rather than for safety.
class Hash {
public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes)
            m_value = (m_value ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ULL;
    }
    template <class T> void add(const T& value) { add(std::as_bytes(std::span(&value, 1))); }
    template <class T> void addAll(std::span<const T> values) { add(std::as_bytes(values)); }
    std::uint64_t value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325ULL;
};

/// How this machine rounds: a hash of FFTW's transforms and of the C library's functions. Both choose their
/// code by the processor, so that equal results are to be expected only where this number is the same.
std::uint64_t roundingOfThisMachine();

} // namespace texloom::test
