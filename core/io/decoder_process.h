#pragma once

#include "core/io/image_decode.h"

#include <cstddef>
#include <functional>

namespace texloom {

/// Samples in memory that another process filled; given back with the object.
class SharedSamples {
public:
    SharedSamples() = default;
    /// Maps `bytes` of a memory file. @throws Error if that fails.
    SharedSamples(int file, std::size_t bytes);
    ~SharedSamples();
    SharedSamples(SharedSamples&& other) noexcept;
    SharedSamples& operator=(SharedSamples&& other) noexcept;

    void* data() const { return m_data; }

private:
    void* m_data = nullptr;
    std::size_t m_bytes = 0;
};

/// Decodes files in processes of their own, so that a library that aborts on a damaged file, or takes all the
/// time and memory there is, ends that process and nothing else. A small process is split off when the
/// program starts, while it is alone and small; it splits off one more for every file.
class DecoderProcess {
public:
    /// Splits off the process that makes the others; first of all in main(), before there are threads.
    /// @param check called every few milliseconds while a file is decoded; what it throws ends the decoding.
    /// Where the system has no process to give, files are decoded in this one.
    static void start(std::function<void()> check = {});
    /// Whether there is one.
    static bool running();
    /// Calls what start() was given, and what this thread's Watch was.
    static void check();

    /// While one of these exists, `check` is called as often for what this thread decodes. Watches of one
    /// thread nest; the innermost counts.
    class Watch {
    public:
        explicit Watch(std::function<void()> check);
        ~Watch();
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;

    private:
        std::function<void()> m_check;
        const Watch* m_outer;
        friend class DecoderProcess;
    };

    struct Decoded {
        DecodedHeader header;
        SharedSamples memory;
        const float* samples = nullptr;
    };
    /// decode() in a process of its own. @throws Error as decode() does, or that the decoder gave up; what
    /// the check throws.
    static Decoded decode(const DecodeRequest& request);
};

} // namespace texloom
