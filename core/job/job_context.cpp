#include "core/job/job_context.h"

#include "core/job/address_space.h"

#include <Eigen/Core>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <utility>

namespace texloom {

namespace {

/// Eigen divides products of matrices as the processor's caches are large, so that sums have another order,
/// and results other bits, on another machine. With sizes that are given the bits are the same on all.
const bool kBlocksAreFixed = [] {
    constexpr std::ptrdiff_t kFirst = 48 << 10, kSecond = 2 << 20, kThird = 32 << 20;
    Eigen::setCpuCacheSizes(kFirst, kSecond, kThird);
    return true;
}();

/// Longest side of a preview: what a viewer fills at 100 %, copied in a few milliseconds.
constexpr int kPreviewSide = 640;
/// Previews may cost this share of the run's time.
constexpr int kPreviewShare = 50;
constexpr std::chrono::milliseconds kPreviewPause{80};
/// How long ordered tasks run between two moments for progress and previews.
constexpr std::chrono::milliseconds kSlice{50};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Image sample(const ImageView& image, Size size, int step) {
    Image sampled(size, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < size.height; ++y) {
            const float* from = image.plane(c).row(y * step);
            float* to = sampled.plane(c).row(y);
            for (int x = 0; x < size.width; ++x)
                to[x] = from[x * step];
        }
    return sampled;
}

PositionMap sample(const PositionMap& map, Size size, int step) {
    PositionMap sampled(size, map.exemplarSizes());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            sampled.at(x, y) = map.at(x * step, y * step);
    return sampled;
}

} // namespace

int threadCount(int asked) {
    return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

double JobMonitor::progress() const {
    const std::lock_guard lock(m_mutex);
    return m_progress;
}

Message JobMonitor::stage() const {
    const std::lock_guard lock(m_mutex);
    return m_stages.empty() ? Message() : m_stages.back().name;
}

std::vector<StageTime> JobMonitor::stageTimes() const {
    const std::lock_guard lock(m_mutex);
    std::vector<StageTime> stages = m_stages;
    if (!stages.empty() && stages.back().seconds == 0)
        stages.back().seconds = secondsSince(m_stageStart);
    return stages;
}

std::vector<Curve> JobMonitor::curves() const {
    const std::lock_guard lock(m_mutex);
    return m_curves;
}

double JobMonitor::seconds() const {
    return secondsSince(m_start);
}

class JobContext::Arena {
public:
    explicit Arena(int threads)
        : m_limit(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(std::max(threads, threadCount(0)))),
          m_arena(startableThreads(threads, addressesLeft())) {}
    tbb::task_arena& arena() { return m_arena; }

private:
    /// oneTBB never starts more threads than there are cores unless it is told so.
    tbb::global_control m_limit;
    tbb::task_arena m_arena;
};

JobContext::JobContext(const JobOptions& options, std::function<bool()> stopped, JobMonitor& monitor,
                       std::function<bool()> kept)
    : m_seed(options.seed), m_random(options.seed), m_threads(threadCount(options.threads)),
      m_previews(options.previews), m_stopped(std::move(stopped)), m_kept(std::move(kept)),
      m_keep(options.keep), m_resumed(options.resumed), m_keepEvery(options.keepEvery), m_monitor(monitor),
      m_arena(std::make_unique<Arena>(m_threads)) {}

JobContext::~JobContext() = default;

void JobContext::check() const {
    if (m_stopped())
        throw Cancelled{};
}

void JobContext::step(std::uint32_t number, double share) {
    if (number > 0)
        m_stepBegin += m_share;
    m_share = share;
    m_stageBegin = m_stepBegin;
    m_stageWeight = 0;
    m_random = Random(m_seed, number);
    m_step = number;
    const std::lock_guard lock(m_monitor.m_mutex);
    m_monitor.m_curves.clear();
}

void JobContext::stage(double weight, Message name) {
    check();
    m_stageBegin += m_stageWeight;
    m_stageWeight = weight * m_share;
    const std::lock_guard lock(m_monitor.m_mutex);
    if (!m_monitor.m_stages.empty())
        m_monitor.m_stages.back().seconds = secondsSince(m_monitor.m_stageStart);
    m_monitor.m_stageStart = Clock::now();
    m_monitor.m_stages.push_back({std::move(name), 0});
    m_monitor.m_progress = std::clamp(m_stageBegin, m_monitor.m_progress, 1.0);
}

void JobContext::progress(double fraction) {
    check();
    const double whole = m_stageBegin + m_stageWeight * std::clamp(fraction, 0.0, 1.0);
    const std::lock_guard lock(m_monitor.m_mutex);
    m_monitor.m_progress = std::clamp(whole, m_monitor.m_progress, 1.0);
}

void JobContext::curve(const Message& name, double value) {
    const std::lock_guard lock(m_monitor.m_mutex);
    addTo(m_monitor.m_curves, name, value);
}

void JobContext::checkpoint(std::chrono::milliseconds every, const std::function<std::string()>& state) {
    if (!m_keep || Clock::now() - m_lastCheckpoint < m_keepEvery.value_or(every))
        return;
    // What is only made again on the way to a checkpoint leaves that for another time.
    if (m_resumed && m_step < m_resumed->step)
        return;
    m_keep({m_step, m_monitor.progress(), state(), m_monitor.curves()});
    m_lastCheckpoint = Clock::now();
}

const std::string* JobContext::resumed() {
    if (!m_resumed || m_resumed->step != m_step)
        return nullptr;
    if (!std::exchange(m_curvesTakenUp, true)) {
        const std::lock_guard lock(m_monitor.m_mutex);
        m_monitor.m_curves = m_resumed->curves;
    }
    return &m_resumed->state;
}

void JobContext::stopWith(Image image, PositionMap map) {
    m_partial = PartialWork{std::move(image), std::move(map), m_monitor.progress()};
    throw StoppedEarly{};
}

PartialWork JobContext::takePartial() {
    return std::move(m_partial).value();
}

void JobContext::preview(const ImageView& image, const PositionMap* map) {
    if (stopsEarly())
        stopWith(Image(image), map ? *map : PositionMap());
    makePreview(image.size(), [&](Size size, int step) {
        return Preview{sample(image, size, step), map ? sample(*map, size, step) : PositionMap(),
                       image.size(), step};
    });
}

void JobContext::preview(Size full, const std::function<Image(Size size, int step)>& made) {
    if (stopsEarly())
        stopWith(made(full, 1), {});
    makePreview(full, [&](Size size, int step) { return Preview{made(size, step), {}, full, step}; });
}

void JobContext::makePreview(Size full, const std::function<Preview(Size size, int step)>& made) {
    if (!previewDue())
        return;
    const auto now = Clock::now();
    const int step = (full.longerSide() + kPreviewSide - 1) / kPreviewSide;
    m_monitor.m_preview.put(made({(full.width + step - 1) / step, (full.height + step - 1) / step}, step));
    const auto done = Clock::now();
    m_nextPreview = done + std::max<Clock::duration>(kPreviewPause, (done - now) * kPreviewShare);
}

namespace {

/// Runs numbered tasks on the threads of the arena that it is used in.
/// oneTBB is not built with the thread sanitizer, which therefore cannot see that a task begins after what
/// was done before it was started, and ends before wait() returns; the gate says both in an atomic of our
/// own.
class Crew {
public:
    explicit Crew(std::function<void(int)> body) : m_body(std::move(body)) {}

    void start(int task) {
        m_gate.fetch_add(1, std::memory_order_release);
        m_group.run([ this, task ]() __attribute__((no_sanitize("thread"))) { perform(task); });
    }

    void wait() {
        const Passage passage{m_gate};
        m_group.wait();
    }

private:
    struct Passage {
        std::atomic<unsigned>& gate;
        ~Passage() { gate.fetch_add(1, std::memory_order_acq_rel); }
    };

    void perform(int task) {
        m_gate.load(std::memory_order_acquire);
        const Passage passage{m_gate};
        m_body(task);
    }

    std::function<void(int)> m_body;
    std::atomic<unsigned> m_gate = 0;
    tbb::task_group m_group;
};

/// Tasks that wait for each other. Runs those that are ready until a deadline, so that the caller gets a
/// moment in which nothing runs.
class TaskGraph {
public:
    TaskGraph(int count, const std::function<std::vector<int>(int)>& before, std::function<void(int)> body)
        : m_body(std::move(body)), m_after(static_cast<std::size_t>(count)),
          m_missing(static_cast<std::size_t>(count)), m_crew([this](int task) { perform(task); }) {
        for (int task = 0; task < count; ++task) {
            const std::vector<int> needed = before(task);
            m_missing[static_cast<std::size_t>(task)] = static_cast<int>(needed.size());
            for (const int earlier : needed)
                m_after[static_cast<std::size_t>(earlier)].push_back(task);
            if (needed.empty())
                m_ready.push_back(task);
        }
    }

    int done() const { return m_done; }

    void runUntil(std::chrono::steady_clock::time_point deadline) {
        m_deadline = deadline;
        std::vector<int> ready;
        ready.swap(m_ready);
        for (const int task : ready)
            m_crew.start(task);
        m_crew.wait();
    }

private:
    void perform(int task) {
        m_body(task);
        ++m_done;
        for (const int next : m_after[static_cast<std::size_t>(task)])
            if (--m_missing[static_cast<std::size_t>(next)] == 0)
                becameReady(next);
    }

    void becameReady(int task) {
        if (std::chrono::steady_clock::now() < m_deadline)
            return m_crew.start(task);
        const std::lock_guard lock(m_mutex);
        m_ready.push_back(task);
    }

    std::function<void(int)> m_body;
    std::vector<std::vector<int>> m_after;
    std::vector<std::atomic<int>> m_missing;
    std::vector<int> m_ready;
    std::mutex m_mutex;
    std::atomic<int> m_done = 0;
    std::chrono::steady_clock::time_point m_deadline;
    Crew m_crew;
};

} // namespace

void JobContext::parallelAfter(int count, const std::function<std::vector<int>(int)>& before,
                               const std::function<void(int)>& body,
                               const std::function<void(int)>& between) {
    m_arena->arena().execute([&] {
        TaskGraph graph(count, before, [&](int task) {
            check();
            body(task);
        });
        while (graph.done() < count) {
            graph.runUntil(Clock::now() + kSlice);
            between(graph.done());
        }
    });
}

void JobContext::parallel(int begin, int end, const std::function<void(int)>& body) {
    std::atomic<int> next = begin;
    m_arena->arena().execute([&] {
        Crew crew([&](int) {
            try {
                for (int i = next++; i < end; i = next++) {
                    check();
                    body(i);
                }
            } catch (...) {
                next = end; // what the other threads still did would be thrown away
                throw;
            }
        });
        for (int worker = 0; worker < std::min(m_threads, end - begin); ++worker)
            crew.start(worker);
        crew.wait();
    });
}

} // namespace texloom
