#pragma once

#include "core/base/message.h"
#include "core/image/image.h"
#include "core/image/position_map.h"
#include "core/job/checkpoint.h"
#include "core/job/curve.h"
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

/// Thrown where a job that is to stop and keep what it has hands that over. A method that has made more than
/// a picture, as one that trains, may catch it and end with all that: the result is marked as stopped all the
/// same.
struct StoppedEarly {};

/// What a job had made when it was told to stop and keep it.
struct PartialWork {
    Image image; ///< of the work's full size at that moment, which may be larger or coarser than the output
    PositionMap map;     ///< empty if the method gave none; pixels without a source were not made yet
    double progress = 0; ///< of the whole job, 0 to 1
};

/// A picture of work under way, small enough to be shown at once: every `step`-th pixel of the work in both
/// directions.
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
    /// The curves so far.
    std::vector<Curve> curves() const;

private:
    friend class JobContext;
    friend class JobRunner;

    mutable std::mutex m_mutex;
    double m_progress = 0;
    std::vector<StageTime> m_stages;
    std::vector<Curve> m_curves;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point m_stageStart = m_start;
    Latest<Preview> m_preview;
};

/// How a job may use the machine.
struct JobOptions {
    std::uint64_t seed = 0;
    int threads = 0;       ///< 0: one per core
    bool previews = false; ///< whether anyone looks at previews
    /// Keeps checkpoints, each in place of the one before; none are made if empty. Called on the job's
    /// thread.
    std::function<void(const Checkpoint&)> keep = {};
    /// What to go on from; null to begin at the beginning.
    std::shared_ptr<const Checkpoint> resumed = nullptr;
    /// How often checkpoints are kept, in place of what the work asks for, as tests do.
    std::optional<std::chrono::milliseconds> keepEvery = std::nullopt;
};

/// All that a method knows of the world while it runs. check(), random() and threads() may be called
/// anywhere; stage(), progress(), preview() and parallel() only on the thread that the job began on.
class JobContext {
public:
    /// @param stopped whether the job is to end at once; asked by check(). @param monitor must outlive the
    /// context. @param kept whether the job is to end with what it has; never if empty.
    JobContext(const JobOptions& options, std::function<bool()> stopped, JobMonitor& monitor,
               std::function<bool()> kept = {});
    ~JobContext();
    JobContext(const JobContext&) = delete;
    JobContext& operator=(const JobContext&) = delete;

    /// Ends the job if that was asked for. Call it at least every 50 ms. @throws Cancelled
    void check() const;
    /// Begins one of several runs that follow each other in one job: it makes up `share` of the whole (all
    /// shares add to 1), its stages make up the whole of it, its random numbers are a stream of their own,
    /// and its curves begin anew.
    void step(std::uint32_t number, double share);
    /// Begins a part of the work that makes up `weight` of the whole run (all weights add to 1).
    void stage(double weight, Message name);
    /// How much of the stage is done, 0 to 1.
    void progress(double fraction);
    /// Adds a value to a curve that others can watch grow; it becomes one of the result's.
    void curve(const Message& name, double value);
    /// Lets the work be taken up again from where it is now: at most every so often, and only where anyone
    /// keeps checkpoints, `state` is called for all that it takes.
    void checkpoint(std::chrono::milliseconds every, const std::function<std::string()>& state);
    /// What `state` said at the checkpoint that this run goes on from; null: it begins at the beginning. Of a
    /// method that repeats to the bit (Repeats::Bits), the result is that of a run which was not broken off.
    /// The first call takes up the curves, too, as they were then, in place of those of this run.
    const std::string* resumed();
    /// Offers the work as it stands to be looked at. Cheap when nobody looks or the last one was just now:
    /// then nothing is copied. Pixels to which `map` gives no source count as not made yet. Where the job is
    /// to stop and keep what it has, this is what it keeps. @throws StoppedEarly
    void preview(const ImageView& image, const PositionMap* map = nullptr);
    /// The same for work that is not at hand as one image of its full size: `made` is called, only if a
    /// preview is due, for an image of `size` that holds every `step`-th pixel of the work.
    void preview(Size full, const std::function<Image(Size size, int step)>& made);
    /// Whether preview() would take a picture now, for methods that must make one for it.
    bool previewDue() const { return stopsEarly() || (m_previews && Clock::now() >= m_nextPreview); }
    /// Random numbers of this job; see Random.
    const Random& random() const { return m_random; }
    int threads() const { return m_threads; }
    /// Time spent in each stage so far.
    std::vector<StageTime> stageTimes() const { return m_monitor.stageTimes(); }
    /// The curves so far.
    std::vector<Curve> curves() const { return m_monitor.curves(); }
    /// What was kept when StoppedEarly was thrown; from then on the job goes on to its end.
    PartialWork takePartial();
    /// How far the whole job was, 0 to 1, when StoppedEarly was thrown; none if it never was.
    std::optional<double> stoppedAt() const {
        return m_partial ? std::optional(m_partial->progress) : std::nullopt;
    }
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
    bool stopsEarly() const { return !m_partial && m_kept && m_kept(); }
    [[noreturn]] void stopWith(Image image, PositionMap map);

    std::uint64_t m_seed;
    Random m_random;
    int m_threads;
    bool m_previews;
    std::function<bool()> m_stopped, m_kept;
    std::function<void(const Checkpoint&)> m_keep;
    std::shared_ptr<const Checkpoint> m_resumed;
    std::optional<std::chrono::milliseconds> m_keepEvery;
    std::optional<PartialWork> m_partial;
    std::uint32_t m_step = 0;
    bool m_curvesTakenUp = false;
    JobMonitor& m_monitor;
    std::unique_ptr<Arena> m_arena;
    double m_stepBegin = 0;
    double m_share = 1;
    double m_stageBegin = 0;
    double m_stageWeight = 0;
    Clock::time_point m_nextPreview = Clock::time_point::min();
    Clock::time_point m_lastCheckpoint = Clock::now();
};

/// Number of threads that `asked` stands for on this machine: itself, or one per core if it is 0.
int threadCount(int asked);

} // namespace texloom
