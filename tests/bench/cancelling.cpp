// How long work takes to end once it is told to, while others compute: every method, and decoding of every
// format.
//   TEXLOOM_CANCEL_SIDE     px of the outputs' sides, 1024 if not given
//   TEXLOOM_CANCEL_LOAD     how many threads compute on this machine meanwhile, 4 if not given
//   TEXLOOM_CANCEL_MOMENTS  how often each is cancelled, 24 if not given

#include "core/base/text.h"
#include "core/io/decoder_process.h"
#include "core/io/image_file.h"
#include "core/job/job.h"
#include "tests/methods/conformance/fixture.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace texloom::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;
constexpr std::chrono::milliseconds kApart{113}; // of moments: all over the first seconds

int numberFrom(const char* name, int otherwise) {
    const char* const asked = std::getenv(name);
    long long number = otherwise;
    if (asked && (!parseInteger(asked, number) || number < 0 || number > 65536))
        number = otherwise;
    return static_cast<int>(number);
}

int moments() {
    return std::max(1, numberFrom("TEXLOOM_CANCEL_MOMENTS", 24));
}

/// How many threads compute on this machine.
int computing() {
    std::ifstream file("/proc/loadavg");
    std::string skipped;
    int running = 0;
    file >> skipped >> skipped >> skipped >> running;
    return running - 1; // this one
}

/// Threads that compute for nothing, as many as bring this machine to the load that was asked for.
class Load {
public:
    Load() {
        for (int n = computing(); n < numberFrom("TEXLOOM_CANCEL_LOAD", 4); ++n)
            m_threads.emplace_back([](const std::stop_token& stop) {
                while (!stop.stop_requested())
                    benchmark::DoNotOptimize(stop);
            });
    }

private:
    std::vector<std::jthread> m_threads;
};

/// @param ended how often there was nothing left to cancel. @param promised in milliseconds.
void tell(benchmark::State& state, std::vector<double> answers, int ended, std::int64_t promised) {
    std::sort(answers.begin(), answers.end());
    const auto at = [&answers](double share) {
        const auto rank = static_cast<std::size_t>(share * static_cast<double>(answers.size()));
        return answers[std::min(rank, answers.size() - 1)];
    };
    state.counters["median [ms]"] = at(0.5);
    state.counters["p99 [ms]"] = at(0.99);
    state.counters["had ended"] = ended;
    state.counters["promised [ms]"] = static_cast<double>(promised);
}

/// A run; what is promised is in MethodInfo::cancelsWithin.
void answerOf(benchmark::State& state, const Method& method) {
    const int side = numberFrom("TEXLOOM_CANCEL_SIDE", 1024);
    const RunPlan plan = test::longPlan(method, {side, side});
    std::vector<double> answers;
    int ended = 0;
    for (auto _ : state) {
        const Load load;
        for (int moment = 0; moment < moments(); ++moment) {
            const auto job = startRun(plan, false);
            std::this_thread::sleep_for(moment * kApart);
            ended += job->finished() ? 1 : 0;
            const auto asked = Clock::now();
            job->cancel();
            static_cast<void>(job->take());
            answers.push_back(Milliseconds(Clock::now() - asked).count());
        }
    }
    tell(state, std::move(answers), ended, method.info().cancelsWithin.count());
}

/// Decoding, at moments all over the time that it takes.
void answerWhileDecoding(benchmark::State& state, const std::string& name) {
    const test::TemporaryFolder folder;
    constexpr Size kSize{4096, 3000};
    const Image tile = test::blobs({64, 64}, 3);
    WriteOptions options;
    options.depth = depthsFor(name).front();
    writeImage(
        folder / name, kSize, 3,
        [&tile](int y, float* row) {
            for (int x = 0; x < kSize.width; ++x)
                for (int c = 0; c < 3; ++c)
                    *row++ = tile(x % 64, y % 64, c);
        },
        options);
    std::atomic<bool> cancelled = false;
    const DecoderProcess::Watch watch([&cancelled] {
        if (cancelled)
            throw Cancelled{};
    });
    const auto begun = Clock::now();
    readImage(folder / name);
    const auto whole = Clock::now() - begun;
    std::vector<double> answers;
    for (auto _ : state) {
        const Load load;
        for (int moment = 0; moment < moments(); ++moment) {
            cancelled = false;
            Clock::time_point asked;
            const std::jthread user([&cancelled, &asked, wait = whole * moment / moments()] {
                std::this_thread::sleep_for(wait);
                asked = Clock::now();
                cancelled = true;
            });
            try {
                readImage(folder / name);
            } catch (const Cancelled&) {
                answers.push_back(Milliseconds(Clock::now() - asked).count());
            }
        }
    }
    const int ended = moments() - static_cast<int>(answers.size());
    answers.push_back(0); // where all were done before
    constexpr std::int64_t kPromised = 100;
    tell(state, std::move(answers), ended, kPromised);
}

template <class Answer> void add(const std::string& name, const Answer& answer) {
    benchmark::RegisterBenchmark(name.c_str(), answer)
        ->Iterations(1)
        ->Unit(benchmark::kSecond)
        ->UseRealTime();
}

} // namespace
} // namespace texloom::bench

int main(int argc, char** argv) {
    using namespace texloom;
    DecoderProcess::start();
    benchmark::Initialize(&argc, argv);
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr", "a.hdr"})
        bench::add(std::string("decoding/") + name,
                   [name](benchmark::State& state) { bench::answerWhileDecoding(state, name); });
    for (const Method& method : methods())
        bench::add(method.id(), [&method](benchmark::State& state) { bench::answerOf(state, method); });
    benchmark::RunSpecifiedBenchmarks();
}
