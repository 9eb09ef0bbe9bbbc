#pragma once

#include "core/base/message.h"
#include "core/image/image.h"
#include "core/image/position_map.h"
#include "core/job/latest.h"
#include "core/job/random.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texloom {

/// Thrown by JobContext::check() when the job is to end; never caught by a method.
struct Cancelled {};

/// A partial result, small enough to be shown at once: every `step`-th pixel of the work in both directions.
struct Preview {
    Image image;
    PositionMap map; ///< empty if the method gave none; pixels without a source are not made yet
    Size fullSize;   ///< of the work that it was taken from, which may be larger than the output
    int step = 1;
};

/// The time one named stage of a job took.
struct StageTime {
    Message name;
    double seconds = 0;
};

/// What a running job lets others see. All members may be called from any thread.
class JobMonitor {
public:
    /// From 0 to 1; never falls.
    double progress() const;
    /// What it does now; empty before the first stage.
    Message stage() const;
    /// The newest preview that was not taken yet.
    std::optional<Preview> takePreview() { return m_preview.take(); }
    /// Finished stages and the one under way.
    std::vector<StageTime> stageTimes() const;
    double seconds() const;

private:
    friend class JobContext;
    friend class JobRunner;

    mutable std::mutex m_mutex;
    double m_progress = 0;
    std::vector<StageTime> m_stages;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point m_stageStart = m_start;
    Latest<Preview> m_preview;
};

/// How a job may use the machine.
struct JobOptions {
    std::uint64_t seed = 0;
    int threads = 0;       ///< 0: one per core
    bool previews = false; ///< whether anyone looks at previews
};

/// All that a method knows of the world while it runs. check(), random() and threads() may be called
/// anywhere; stage(), progress(), preview() and parallel() only on the thread that the job began on.
class JobContext {
public:
    /// `stopped` is asked by check(); `monitor` must outlive the context.
    JobContext(const JobOptions& options, std::function<bool()> stopped, JobMonitor& monitor);
    ~JobContext();
    JobContext(const JobContext&) = delete;
    JobContext& operator=(const JobContext&) = delete;

    /// Ends the job if that was asked for. Call it at least every 50 ms. @throws Cancelled
    void check() const;
    /// Begins one of several runs that follow each other in one job: it makes up `share` of the whole (all
    /// shares add to 1), its stages make up the whole of it, and its random numbers are a stream of their
    /// own.
    void step(std::uint32_t number, double share);
    /// Begins a part of the work that makes up `weight` of the whole run (all weights add to 1).
    void stage(double weight, Message name);
    /// How much of the stage is done, 0 to 1.
    void progress(double fraction);
    /// Offers the work as it stands to be looked at. Cheap when nobody looks or the last one was just now:
    /// then nothing is copied. Pixels to which `map` gives no source count as not made yet.
    void preview(const ImageView& image, const PositionMap* map = nullptr);
    /// The same for work that is not at hand as one image of its full size: `made` is called, only if a
    /// preview is due, for an image of `size` that holds every `step`-th pixel of the work.
    void preview(Size full, const std::function<Image(Size size, int step)>& made);
    /// Whether preview() would take a picture now, for methods that must make one for it.
    bool previewDue() const { return m_previews && Clock::now() >= m_nextPreview; }
    /// Random numbers of this job; see Random.
    const Random& random() const { return m_random; }
    int threads() const { return m_threads; }
    /// Time spent in each stage so far.
    std::vector<StageTime> stageTimes() const { return m_monitor.stageTimes(); }
    /// Calls body(i) for each i in [begin, end) on the job's threads, in any order, and returns when all are
    /// done. The body checks for cancellation itself where one call is long; between calls it is done here.
    void parallel(int begin, int end, const std::function<void(int)>& body);
    /// Calls body(i) for each i in [0, count) on the job's threads, each once those that before(i) lists are
    /// done (all smaller than i); in any other respect the order is free.
    /// @param between called with the number done every few hundredths of a second, while no body runs: the
    /// place for progress() and preview().
    void parallelAfter(int count, const std::function<std::vector<int>(int)>& before,
                       const std::function<void(int)>& body, const std::function<void(int)>& between);

private:
    class Arena;
    using Clock = std::chrono::steady_clock;

    void makePreview(Size full, const std::function<Preview(Size size, int step)>& made);

    std::uint64_t m_seed;
    Random m_random;
    int m_threads;
    bool m_previews;
    std::function<bool()> m_stopped;
    JobMonitor& m_monitor;
    std::unique_ptr<Arena> m_arena;
    double m_stepBegin = 0;
    double m_share = 1;
    double m_stageBegin = 0;
    double m_stageWeight = 0;
    Clock::time_point m_nextPreview = Clock::time_point::min();
};

/// Number of threads that `asked` stands for on this machine: itself, or one per core if it is 0.
int threadCount(int asked);

} // namespace texloom
