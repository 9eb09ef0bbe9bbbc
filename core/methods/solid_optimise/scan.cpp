// One voxel after the other (Wei, "Texture synthesis from multiple sources", SIGGRAPH Sketches 2003): each is
// the mean of the pixels whose neighbourhoods are most like its own in slices square to each axis.

#include "core/base/at.h"
#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/job/voxel_random.h"
#include "core/match/neighbourhood_tree.h"
#include "core/methods/solid_optimise/problem.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace texloom::solid_optimise {

namespace {

constexpr int kLeaves = 3;        ///< of the tree that are looked at
constexpr double kSettled = 1e-4; ///< change, as a share of the exemplar's variance, that ends the scans

/// What a scan of z after z, row after row, has made when it comes to the centre.
PixelRuns madeBefore(Axis axis, int side) {
    if (axis != Axis::X)
        return causalRuns(side);
    PixelRuns runs; // x stays: z runs to the right, and all of an earlier z is there
    const int reach = side / 2;
    for (int dy = -reach; dy <= reach; ++dy)
        runs.push_back({-reach, dy, dy < 0 ? reach + 1 : reach});
    return runs;
}

/// What slices square to one axis are compared with.
struct Comparison {
    Comparison(const Image& exemplar, Axis of, float share, const PixelRuns& shown, JobContext& context)
        : axis(of), weight(share), runs(shown), pixels(exemplar.size(), exemplar.channels()),
          set(Neighbourhood({{runs, false, {}}}, {pixels.pixel}), source(exemplar),
              [&context] { context.check(); }),
          tree(set, {}, context) {}

    std::vector<NeighbourhoodSource> source(const Image& exemplar) {
        pixels.load(exemplar, 0, 0, exemplar.size());
        return {{{&pixels}, {}, 1}};
    }

    Axis axis;
    float weight;
    PixelRuns runs;
    Interleaved pixels;
    NeighbourhoodSet set;
    NeighbourhoodTree tree;
};

class Scanner {
public:
    Scanner(const Problem& problem, int scale)
        : m_context(problem.context()), m_side(sideAt(problem.settings(), scale)) {
        const int square = oddSide(problem.settings().patch);
        m_reach = square / 2;
        for (const SliceGoal& goal : problem.goals()) {
            Image exemplar = goal.exemplar;
            for (int n = 0; n < scale; ++n)
                exemplar = halved(exemplar);
            const auto weight = static_cast<float>(goal.weight / problem.wholeWeight());
            m_causal.emplace_back(exemplar, goal.axis, weight, madeBefore(goal.axis, square), m_context);
            m_whole.emplace_back(exemplar, goal.axis, weight, squareRuns(square), m_context);
        }
    }

    /// One scan. @param whole whether neighbourhoods show all voxels, or those that were made before.
    /// @return the mean square of the change.
    double scan(Volume& solid, bool whole) {
        const Volume before = solid;
        const auto& comparisons = whole ? m_whole : m_causal;
        m_context.parallelAfter(
            m_side * m_side,
            [&](int i) {
                std::vector<int> waiting;
                const int y = i % m_side, z = i / m_side;
                if (y > 0)
                    waiting.push_back(i - 1);
                if (z > 0)
                    waiting.push_back((z - 1) * m_side + std::min(y + m_reach, m_side - 1));
                return waiting;
            },
            [&](int i) {
                m_context.check();
                scanRow(comparisons, before, i % m_side, i / m_side, solid);
            },
            [](int) {});
        double sum = 0;
        for (int c = 0; c < solid.channels(); ++c)
            for (std::int64_t i = 0; i < solid.size().voxels(); ++i) {
                const auto change = static_cast<double>(solid.row(0, 0, c)[i] - before.row(0, 0, c)[i]);
                sum += change * change;
            }
        return sum / static_cast<double>(solid.size().voxels());
    }

private:
    /// A voxel of this scan if it was made before the one at `here`, else of the scan before, as are all
    /// beyond the borders, so that rows need not wait for each other.
    const Volume& holding(const Volume& before, const Volume& solid, const SliceVoxel& v,
                          const SliceVoxel& here) const {
        const bool within = v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < m_side && v.y < m_side && v.z < m_side;
        const bool earlier = v.z != here.z ? v.z < here.z : v.y != here.y ? v.y < here.y : v.x < here.x;
        return within && earlier ? solid : before;
    }

    void scanRow(const std::deque<Comparison>& comparisons, const Volume& before, int y, int z,
                 Volume& solid) {
        const auto wrapped = [this](int place) { return (place + m_side) % m_side; };
        std::vector<float> wanted, mean(at(solid.channels()));
        for (int x = 0; x < m_side; ++x) {
            const SliceVoxel here{x, y, z};
            std::fill(mean.begin(), mean.end(), 0.0F);
            for (const Comparison& one : comparisons) {
                wanted.assign(at(one.set.neighbourhood().length()), 0.0F);
                float* to = wanted.data();
                for (const PixelRun& run : one.runs)
                    for (int i = 0; i < run.count; ++i, to += one.pixels.pixel) {
                        SliceVoxel v = sliceVoxel(one.axis, run.dx + i, run.dy, 0);
                        v = {x + v.x, y + v.y, z + v.z};
                        const Volume& from = holding(before, solid, v, here);
                        for (int c = 0; c < solid.channels(); ++c)
                            to[c] = from(wrapped(v.x), wrapped(v.y), wrapped(v.z), c);
                    }
                const Source found = one.tree.nearest(wanted.data(), kLeaves);
                const float* pixel = one.pixels.at(found.x, found.y);
                for (int c = 0; c < solid.channels(); ++c)
                    mean[at(c)] += one.weight * pixel[c];
            }
            for (int c = 0; c < solid.channels(); ++c)
                solid(x, y, z, c) = mean[at(c)];
        }
    }

    JobContext& m_context;
    int m_side, m_reach = 0;
    std::deque<Comparison> m_causal, m_whole;
};

/// Random pixels of the exemplars in every voxel.
Volume scattered(const Problem& problem, int side) {
    JobContext& context = problem.context();
    Volume solid({side, side, side}, problem.channels());
    const VoxelRandom random(context.random().bits(0, 0, 3));
    const Image& from = problem.goals().front().exemplar;
    for (int z = 0; z < side; ++z, context.check())
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto pick = [&](int count, std::uint32_t n) {
                    return static_cast<int>(random.below(static_cast<std::uint32_t>(count), {x, y, z}, n));
                };
                const int u = pick(from.width(), 0), v = pick(from.height(), 1);
                for (int c = 0; c < solid.channels(); ++c)
                    solid(x, y, z, c) = from(u, v, c);
            }
    return solid;
}

double varianceOf(const Problem& problem) {
    double sum = 0;
    for (const SliceGoal& goal : problem.goals())
        sum += channelCovariance(goal.exemplar).trace() / static_cast<double>(problem.goals().size());
    return sum;
}

} // namespace

Volume scanned(const Problem& problem, int scales) {
    JobContext& context = problem.context();
    Progress progress{scales - 1, 0, Volume(), {}};
    if (const std::string* earlier = context.resumed())
        progress = Progress::from(*earlier);
    else
        progress.solid = scattered(problem, sideAt(problem.settings(), scales - 1));
    const int iterations = problem.settings().iterations;
    const double settled = kSettled * varianceOf(problem);
    const double whole = 0.9 * (1 - 0.125) / (1 - std::pow(0.125, scales));
    for (int scale = scales - 1; scale >= 0; --scale) {
        context.stage(whole * std::pow(0.125, scale), TR("Scanning"));
        if (scale > progress.scale)
            continue;
        if (progress.solid.width() != sideAt(problem.settings(), scale))
            progress.solid = enlarged(progress.solid, sideAt(problem.settings(), scale), context);
        progress.scale = scale;
        Scanner scanner(problem, scale);
        for (int n = progress.iteration; n < iterations; ++n) {
            const double change = scanner.scan(progress.solid, scale < scales - 1 || n > 0);
            matchColours(problem, progress.solid); // means of neighbours drift
            context.curve(TR("Change"), change);
            problem.show(progress.solid);
            progress.iteration = n + 1;
            context.checkpoint(std::chrono::seconds(30), [&] { return progress.bytes(); });
            if (change <= settled)
                break;
            context.progress((n + 1.0) / iterations);
        }
        context.progress(1);
        progress.iteration = 0;
    }
    return std::move(progress.solid);
}

} // namespace texloom::solid_optimise
