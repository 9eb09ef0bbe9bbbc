#include "core/io/decoder_worker.h"

#include "core/base/error.h"
#include "core/io/message_json.h"
#include "core/job/memory.h"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>

namespace texloom {

namespace {

using Json = nlohmann::ordered_json;

/// Seconds of work that a header may take, and samples for which there is one more.
constexpr std::uint64_t kSeconds = 20, kSamplesASecond = 8'000'000;
/// How much longer it may take by the clock: disks far away are slow.
constexpr std::uint64_t kPatience = 15;
/// What a decoder may take beside the samples.
constexpr std::uint64_t kScratch = 128U << 20;

int answerTo = -1;

void onTimeOver(int) {
    sendPlain(answerTo, Packet::TooLong);
    ::_exit(1);
}

void limitTo(decltype(RLIMIT_CPU) resource, std::uint64_t amount) {
    rlimit limits{};
    ::getrlimit(resource, &limits);
    limits.rlim_cur = std::min<rlim_t>(amount, limits.rlim_max);
    ::setrlimit(resource, &limits);
}

/// Of work, and by the clock for those that only wait.
void limitTime(std::uint64_t samples) {
    const std::uint64_t seconds = kSeconds + samples / kSamplesASecond;
    limitTo(RLIMIT_CPU, seconds);
    ::alarm(static_cast<unsigned>(kPatience * seconds));
}

void setLimits([[maybe_unused]] const DecodeRequest& request) {
    std::signal(SIGXCPU, onTimeOver);
    std::signal(SIGALRM, onTimeOver);
    limitTime(0);
    limitTo(RLIMIT_CORE, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // whose own tables are larger
    if (request.memory > 0)
        limitTo(RLIMIT_DATA, dataMemory() + request.memory + kScratch);
#endif
}

DecodeRequest requestFrom(const std::string& text) {
    const std::size_t end = std::min(text.find('\0'), text.size() - 1);
    const Json json = Json::parse(text.substr(0, end));
    DecodeRequest request;
    request.path = text.substr(end + 1);
    request.pixels = json.at("pixels").get<bool>();
    request.largestPixels = json.at("largestPixels").get<std::int64_t>();
    request.layer = json.at("layer").get<std::string>();
    request.memory = json.at("memory").get<std::uint64_t>();
    request.memoryText = messageFrom(json.at("memoryText"));
    return request;
}

/// Memory that can be handed to another process.
class SharedMemory {
public:
    SharedMemory() : m_file(::memfd_create("image", MFD_CLOEXEC)) {}

    /// Room for samples, which is there until the process ends.
    float* samples(std::size_t count) {
        m_bytes = count * sizeof(float);
        if (::ftruncate(m_file.number(), static_cast<off_t>(m_bytes)) != 0)
            throw std::bad_alloc();
        void* const place = ::mmap(nullptr, m_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, m_file.number(), 0);
        if (place == MAP_FAILED)
            throw std::bad_alloc();
        return static_cast<float*>(place);
    }

    /// All of it, with a text behind the samples.
    Packet with(const std::string& text) {
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t count = ::pwrite(m_file.number(), text.data() + done, text.size() - done,
                                           static_cast<off_t>(m_bytes + done));
            if (count <= 0)
                throw std::bad_alloc();
            done += static_cast<std::size_t>(count);
        }
        return {Packet::Done, m_bytes, {}, std::move(m_file)};
    }

private:
    Handle m_file;
    std::size_t m_bytes = 0;
};

Packet failure(std::uint64_t number, const Message& sentence) {
    return {
        Packet::Failure, number, toJson(sentence).dump(-1, ' ', false, Json::error_handler_t::replace), {}};
}

Packet answerFor(const DecodeRequest& request) {
    try {
        SharedMemory memory;
        const DecodedHeader header = decode(request, [&](std::size_t samples) {
            limitTime(samples);
            return memory.samples(samples);
        });
        return memory.with(header.toJson());
    } catch (const UsageError& error) {
        return failure(kUsageFailure, error.message());
    } catch (const Error& error) {
        return failure(0, error.message());
    } catch (const std::bad_alloc&) {
        return failure(0, message("{} takes more memory to decode than there is.", request.path.string()));
    }
}

} // namespace

std::string requestText(const DecodeRequest& request) {
    const Json json = {{"pixels", request.pixels},
                       {"largestPixels", request.largestPixels},
                       {"layer", request.layer},
                       {"memory", request.memory},
                       {"memoryText", toJson(request.memoryText)}};
    // The name may be anything but not hold a zero.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\0' + request.path.string();
}

void decodeFor(const std::string& text, const Handle& answer) {
    answerTo = answer.number();
    answer.send({Packet::Id, static_cast<std::uint64_t>(::getpid()), {}, {}});
    const DecodeRequest request = requestFrom(text);
    setLimits(request);
    // One thread is enough, and those of a pool would count against the limit of memory.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    answer.send(answerFor(request));
}

} // namespace texloom
