// Sliced optimal transport of the patches of all slices (Elnekave & Weiss 2022, in a solid).

#include "core/base/at.h"
#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/job/pool.h"
#include "core/match/patch_projection.h"
#include "core/match/tap_sums.h"
#include "core/math/histogram.h"
#include "core/methods/solid_optimise/padded.h"
#include "core/methods/solid_optimise/problem.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::solid_optimise {

namespace {

/// As in the method of pictures: patches are moved less and less far at the end of a scale.
constexpr double kPace = 0.9, kLastPace = 0.1, kSlowing = 0.5;
/// Directions whose numbers are in memory at a time.
constexpr int kBatch = 4;

class PatchMatcher {
public:
    PatchMatcher(const Problem& problem, int scale);
    /// One iteration. @return the mean square of the patches' ways.
    double step(Volume& solid, int number, double pace);

private:
    struct Workspace {
        SampleRanks ranks;
        std::vector<float> wanted, row, moved;
        std::vector<const float*> taps;
    };

    std::vector<float> drawDirection(int number, std::size_t goal, int k) const;
    Histogram wantedAlong(const Image& exemplar, std::span<const float> direction, Workspace& work) const;
    double moveAlong(std::size_t goal, std::span<const float> direction, Padded& numbers);
    void spread(Axis axis, std::span<const float> directions, int count, double factor);

    const Problem& m_problem;
    JobContext& m_context;
    int m_side, m_patch, m_channels;
    std::vector<Image> m_exemplars;
    std::vector<Padded> m_solid;   ///< one for each channel
    std::vector<Padded> m_numbers; ///< one for each direction of a batch
    Volume m_change;
    Pool<Workspace> m_pool;
};

PatchMatcher::PatchMatcher(const Problem& problem, int scale)
    : m_problem(problem), m_context(problem.context()), m_side(sideAt(problem.settings(), scale)),
      m_patch(problem.settings().patch), m_channels(problem.channels()),
      m_solid(at(m_channels), Padded(m_side, 0, m_patch - 1)),
      m_numbers(kBatch, Padded(m_side, m_patch - 1, 0)), m_change({m_side, m_side, m_side}, m_channels) {
    for (const SliceGoal& goal : problem.goals()) {
        m_exemplars.push_back(goal.exemplar);
        for (int n = 0; n < scale; ++n)
            m_exemplars.back() = halved(m_exemplars.back());
    }
}

std::vector<float> PatchMatcher::drawDirection(int number, std::size_t goal, int k) const {
    std::vector<double> values;
    double squares = 0;
    for (int i = 0; i < m_channels * m_patch * m_patch; ++i) {
        values.push_back(m_context.random().normal(
            i, number, static_cast<std::uint32_t>(3 * k) + static_cast<std::uint32_t>(goal)));
        squares += values.back() * values.back();
    }
    std::vector<float> direction;
    for (const double value : values)
        direction.push_back(static_cast<float>(value / std::sqrt(squares)));
    return direction;
}

Histogram PatchMatcher::wantedAlong(const Image& exemplar, std::span<const float> direction,
                                    Workspace& work) const {
    const PatchProjection projection(exemplar.size(), Wrap{}, m_patch);
    const Size positions = projection.positions();
    work.wanted.resize(static_cast<std::size_t>(positions.area()));
    for (int y = 0; y < positions.height; ++y)
        projection.projectRow(exemplar, direction, y, work.wanted.data() + at(y) * at(positions.width));
    const int count = static_cast<int>(work.wanted.size());
    return Histogram({work.wanted.data(), count, 1, count}, [this] { m_context.check(); });
}

/// Puts the ways of all patches along a direction into `numbers`. @return their mean square.
double PatchMatcher::moveAlong(std::size_t goal, std::span<const float> direction, Padded& numbers) {
    const Axis axis = m_problem.goals()[goal].axis;
    const auto work = m_pool.borrow([] { return Workspace{}; });
    const Histogram wanted = wantedAlong(m_exemplars[goal], direction, *work);
    work->row.resize(at(m_side) * at(m_side) * at(m_side));
    float* to = work->row.data();
    for (int z = 0; z < m_side; ++z) {
        m_context.check();
        for (int y = 0; y < m_side; ++y, to += m_side) {
            work->taps.clear();
            for (const Padded& channel : m_solid)
                channel.taps(axis, m_patch, 1, y, z, work->taps);
            sumTaps(work->taps.data(), direction.data(), static_cast<int>(work->taps.size()), m_side, to);
        }
    }
    work->moved = work->row;
    const double square = wanted.match({work->moved.data(), m_side, m_side * m_side, m_side}, work->ranks,
                                       [this] { m_context.check(); });
    const float* before = work->row.data();
    const float* after = work->moved.data();
    for (int z = 0; z < m_side; ++z)
        for (int y = 0; y < m_side; ++y) {
            float* row = numbers.begin(y, z);
            for (int x = 0; x < m_side; ++x)
                row[x] = *after++ - *before++;
            numbers.wrap(y, z);
        }
    return square;
}

/// Adds to the change of every voxel what the patches that cover it want.
void PatchMatcher::spread(Axis axis, std::span<const float> directions, int count, double factor) {
    const int square = m_patch * m_patch;
    m_context.parallel(0, m_side, [&](int z) {
        const auto work = m_pool.borrow([] { return Workspace{}; });
        std::vector<float> weights(at(count) * at(square)), row(at(m_side));
        for (int y = 0; y < m_side; ++y) {
            work->taps.clear();
            for (int k = 0; k < count; ++k)
                m_numbers[at(k)].taps(axis, m_patch, -1, y, z, work->taps);
            for (int c = 0; c < m_channels; ++c) {
                for (int k = 0; k < count; ++k)
                    for (int i = 0; i < square; ++i)
                        weights[at(k) * at(square) + at(i)] =
                            static_cast<float>(factor) *
                            directions[(at(k) * at(m_channels) + at(c)) * at(square) + at(i)];
                sumTaps(work->taps.data(), weights.data(), count * square, m_side, row.data());
                float* change = m_change.row(y, z, c);
                for (int x = 0; x < m_side; ++x)
                    change[x] += row[at(x)];
            }
        }
    });
}

double PatchMatcher::step(Volume& solid, int number, double pace) {
    m_context.parallel(0, m_side, [&](int z) {
        for (int c = 0; c < m_channels; ++c)
            for (int y = 0; y < m_side; ++y) {
                std::copy_n(solid.row(y, z, c), m_side, m_solid[at(c)].begin(y, z));
                m_solid[at(c)].wrap(y, z);
                std::fill_n(m_change.row(y, z, c), m_side, 0.0F);
            }
    });
    const int count = m_problem.settings().directions;
    const double length = m_channels * m_patch * m_patch;
    double sum = 0;
    for (std::size_t goal = 0; goal < m_exemplars.size(); ++goal) {
        const SliceGoal& wanted = m_problem.goals()[goal];
        const double factor = pace * std::max(1.0, length / count) / (m_patch * m_patch) * wanted.weight /
                              m_problem.wholeWeight();
        for (int first = 0; first < count; first += kBatch) {
            const int batch = std::min(kBatch, count - first);
            std::vector<float> directions;
            for (int k = 0; k < batch; ++k) {
                const std::vector<float> one = drawDirection(number, goal, first + k);
                directions.insert(directions.end(), one.begin(), one.end());
            }
            std::array<double, kBatch> squares{};
            const std::size_t each = directions.size() / at(batch);
            m_context.parallel(0, batch, [&](int k) {
                squares[at(k)] = moveAlong(
                    goal, std::span<const float>(directions).subspan(at(k) * each, each), m_numbers[at(k)]);
            });
            for (int k = 0; k < batch; ++k)
                sum += squares[at(k)] / count / static_cast<double>(m_exemplars.size());
            spread(wanted.axis, directions, batch, factor);
        }
    }
    m_context.parallel(0, m_side, [&](int z) {
        for (int c = 0; c < m_channels; ++c)
            for (int y = 0; y < m_side; ++y) {
                float* row = solid.row(y, z, c);
                const float* change = m_change.row(y, z, c);
                for (int x = 0; x < m_side; ++x)
                    row[x] += change[x];
            }
    });
    return sum;
}

} // namespace

Volume matchPatches(const Problem& problem, int scales) {
    JobContext& context = problem.context();
    Progress progress{scales - 1, 0, Volume(), {}};
    if (const std::string* earlier = context.resumed())
        progress = Progress::from(*earlier);
    else
        progress.solid = noise(sideAt(problem.settings(), scales - 1), problem.channels(), context);
    const int iterations = problem.settings().iterations;
    const int steady = static_cast<int>((1 - kSlowing) * iterations);
    const double whole = 0.9 * (1 - 0.125) / (1 - std::pow(0.125, scales));
    for (int scale = scales - 1; scale >= 0; --scale) {
        context.stage(whole * std::pow(0.125, scale), TR("Matching patches"));
        if (scale > progress.scale)
            continue;
        if (progress.solid.width() != sideAt(problem.settings(), scale))
            progress.solid = enlarged(progress.solid, sideAt(problem.settings(), scale), context);
        progress.scale = scale;
        PatchMatcher matcher(problem, scale);
        for (int n = progress.iteration; n < iterations; ++n) {
            const double late =
                static_cast<double>(std::max(0, n - steady)) / std::max(1, iterations - steady);
            const double distance =
                matcher.step(progress.solid, scale * iterations + n, kPace + late * (kLastPace - kPace));
            context.curve(TR("Distance of patches"), distance);
            context.progress((n + 1.0) / iterations);
            problem.show(progress.solid);
            progress.iteration = n + 1;
            context.checkpoint(std::chrono::seconds(30), [&] { return progress.bytes(); });
        }
        progress.iteration = 0;
    }
    return std::move(progress.solid);
}

} // namespace texloom::solid_optimise
