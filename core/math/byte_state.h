#pragma once

#include "core/base/error.h"
#include "core/base/text.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace texloom {

/// Writes numbers one after another, bit for bit, for checkpoints, which the same build on the same machine
/// reads.
class StateWriter {
public:
    template <class T> void add(const T& number) {
        static_assert(std::is_arithmetic_v<T>);
        m_bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    /// With its length.
    void add(const std::vector<float>& values) {
        add(static_cast<std::uint64_t>(values.size()));
        m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    }
    void add(const std::string& bytes) {
        add(static_cast<std::uint64_t>(bytes.size()));
        m_bytes += bytes;
    }
    std::string take() { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

/// Reads them again in the same order. @throws Error if they are not all there.
class StateReader {
public:
    explicit StateReader(std::string_view bytes) : m_bytes(bytes) {}

    template <class T> T number() {
        T number;
        std::memcpy(&number, bytes(sizeof number).data(), sizeof number);
        return number;
    }
    std::vector<float> floats() {
        const auto count = number<std::uint64_t>();
        if (count > m_bytes.size() / sizeof(float))
            refuse();
        std::vector<float> values(count);
        std::memcpy(values.data(), bytes(count * sizeof(float)).data(), count * sizeof(float));
        return values;
    }
    std::string_view text() { return bytes(number<std::uint64_t>()); }

private:
    [[noreturn]] static void refuse() {
        fail(TR("The checkpoint does not suit this run: start again without --resume."));
    }
    std::string_view bytes(std::uint64_t count) {
        if (count > m_bytes.size())
            refuse();
        const std::string_view taken = m_bytes.substr(0, count);
        m_bytes.remove_prefix(count);
        return taken;
    }

    std::string_view m_bytes;
};

} // namespace texloom
