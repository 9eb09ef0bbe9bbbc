// Histograms of steerable pyramids of all slices, averaged (Heeger & Bergen 1995; Gutierrez 2020, fig. 2.15).

#include "core/base/at.h"
#include "core/base/text.h"
#include "core/job/pool.h"
#include "core/math/histogram.h"
#include "core/math/steerable_pyramid.h"
#include "core/methods/solid_optimise/problem.h"

#include <algorithm>
#include <memory>

namespace texloom::solid_optimise {

namespace {

constexpr int kOrientations = 4;

/// The distributions of the parts of one channel of an exemplar.
using Target = std::vector<Histogram>;

/// Takes slices of one size apart and puts them together again, on the thread that it is lent to.
class SliceWorker {
public:
    SliceWorker(const SteerablePyramid& pyramid, JobContext& context)
        : picture(pyramid.size(0), 1), m_pyramid(pyramid), m_context(context) {
        m_parts.push_back({0, kHigh, pyramid.spectrum(0)});
        for (int scale = 0; scale < pyramid.scales(); ++scale)
            for (int k = 0; k < pyramid.orientations(); ++k)
                m_parts.push_back({scale, k, pyramid.spectrum(scale)});
        m_parts.push_back({pyramid.scales(), kLow, pyramid.spectrum(pyramid.scales())});
        for (int scale = 0; scale <= pyramid.scales(); ++scale) {
            m_spectra.push_back(pyramid.spectrum(scale));
            m_planes.emplace_back(pyramid.size(scale), 1);
        }
    }

    /// The distribution of every part of the picture.
    Target measured() {
        Target target;
        apart([&](std::size_t, const PlaneSpan& plane) { target.emplace_back(plane); });
        return target;
    }
    /// Gives every part of the picture its distribution, and makes the picture of them.
    void match(const Target& target) {
        apart([&](std::size_t part, const PlaneSpan& plane) {
            target[part].match(plane, m_ranks, [this] { m_context.check(); });
        });
        together();
    }

    Image picture;

private:
    using Spectrum = FftBuffer<SteerablePyramid::Complex>;
    struct Part {
        int scale;
        int orientation; ///< or kHigh or kLow
        Spectrum spectrum;
    };
    static constexpr int kHigh = -1, kLow = -2;

    template <class Visit> void apart(const Visit& visit) {
        const auto check = [this] { m_context.check(); };
        m_pyramid.forward(0, picture.plane(0).data, m_spectra.front().data(), check);
        m_pyramid.takeHigh(m_spectra.front().data(), m_parts.front().spectrum.data(), check);
        m_pyramid.limit(0, m_spectra.front().data(), check);
        for (std::size_t scale = 0; scale + 1 < m_spectra.size(); ++scale)
            m_pyramid.lower(static_cast<int>(scale), m_spectra[scale].data(), m_spectra[scale + 1].data(),
                            check);
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            Part& part = m_parts[i];
            const Spectrum& whole = m_spectra[at(part.scale)];
            if (part.orientation >= 0)
                m_pyramid.takeBand(part.scale, part.orientation, whole.data(), part.spectrum.data(), check);
            else if (part.orientation == kLow)
                std::copy_n(whole.data(), whole.size(), part.spectrum.data());
            Image& plane = m_planes[at(part.scale)];
            m_pyramid.backward(part.scale, part.spectrum.data(), plane.plane(0).data, check);
            visit(i, plane.plane(0));
            m_pyramid.forward(part.scale, plane.plane(0).data, part.spectrum.data(), check);
        }
    }

    void together() {
        const auto check = [this] { m_context.check(); };
        std::copy_n(m_parts.back().spectrum.data(), m_parts.back().spectrum.size(), m_spectra.back().data());
        for (int scale = m_pyramid.scales(); scale-- > 0;) {
            Spectrum& current = m_spectra[at(scale)];
            std::fill_n(current.data(), current.size(), 0.0F);
            m_pyramid.limit(scale + 1, m_spectra[at(scale + 1)].data(), check);
            m_pyramid.raise(scale, m_spectra[at(scale + 1)].data(), current.data(), check);
            for (const Part& part : m_parts)
                if (part.scale == scale && part.orientation >= 0)
                    m_pyramid.addBand(scale, part.orientation, part.spectrum.data(), current.data(), check);
        }
        m_pyramid.limit(0, m_spectra.front().data(), check);
        m_pyramid.addHigh(m_parts.front().spectrum.data(), m_spectra.front().data(), check);
        m_pyramid.backward(0, m_spectra.front().data(), picture.plane(0).data, check);
    }

    const SteerablePyramid& m_pyramid;
    JobContext& m_context;
    std::vector<Part> m_parts;
    std::vector<Spectrum> m_spectra; ///< of each scale before it is taken apart
    std::vector<Image> m_planes;     ///< of each scale
    SampleRanks m_ranks;
};

/// Matches all slices of a solid, and averages what those square to different axes make of it.
class PyramidMatcher {
public:
    PyramidMatcher(const Problem& problem, int scales)
        : m_problem(problem), m_context(problem.context()), m_side(problem.settings().side),
          m_pyramid({m_side, m_side}, scales, kOrientations),
          m_sum({m_side, m_side, m_side}, problem.channels()) {
        for (const SliceGoal& goal : problem.goals()) {
            const SteerablePyramid own(goal.exemplar.size(), scales, kOrientations);
            SliceWorker worker(own, m_context);
            std::vector<Target>& targets = m_targets.emplace_back();
            for (int c = 0; c < goal.exemplar.channels(); ++c) {
                m_context.check();
                worker.picture = Image(goal.exemplar.view().channelRange(c, 1));
                targets.push_back(worker.measured());
            }
        }
    }

    /// One round. @return the mean square of the change before colours are matched.
    double step(Volume& solid) {
        for (int c = 0; c < solid.channels(); ++c)
            std::fill_n(m_sum.row(0, 0, c), m_sum.size().voxels(), 0.0F);
        for (std::size_t goal = 0; goal < m_targets.size(); ++goal)
            m_context.parallel(0, m_side, [&](int n) { matchSlice(goal, n, solid); });
        double change = 0;
        const auto count = static_cast<double>(solid.size().voxels()) * solid.channels();
        for (int c = 0; c < solid.channels(); ++c) {
            m_context.check();
            float* to = solid.row(0, 0, c);
            const float* from = m_sum.row(0, 0, c);
            for (std::int64_t i = 0; i < solid.size().voxels(); ++i) {
                const auto difference = static_cast<double>(from[i] - to[i]);
                change += difference * difference / count;
                to[i] = from[i];
            }
        }
        return change;
    }

private:
    void matchSlice(std::size_t number, int n, const Volume& solid) {
        const SliceGoal& goal = m_problem.goals()[number];
        const auto worker = m_pool.borrow([&] { return SliceWorker(m_pyramid, m_context); });
        const auto weight = static_cast<float>(goal.weight / m_problem.wholeWeight());
        for (int c = 0; c < solid.channels(); ++c) {
            const auto everyPixel = [&](const auto& visit) {
                for (int down = 0; down < m_side; ++down)
                    for (int right = 0; right < m_side; ++right)
                        visit(right, down, sliceVoxel(goal.axis, right, down, n));
            };
            everyPixel([&](int right, int down, const SliceVoxel& v) {
                worker->picture(right, down, 0) = solid(v.x, v.y, v.z, c);
            });
            worker->match(m_targets[number][at(c)]);
            everyPixel([&](int right, int down, const SliceVoxel& v) {
                m_sum(v.x, v.y, v.z, c) += weight * worker->picture(right, down, 0);
            });
        }
    }

    const Problem& m_problem;
    JobContext& m_context;
    int m_side;
    SteerablePyramid m_pyramid;
    std::vector<std::vector<Target>> m_targets; ///< of each goal and channel
    Volume m_sum;
    Pool<SliceWorker> m_pool;
};

} // namespace

Volume matchPyramids(const Problem& problem, int scales) {
    JobContext& context = problem.context();
    const int side = problem.settings().side;
    context.stage(0.9, TR("Matching histograms"));
    Progress progress;
    if (const std::string* earlier = context.resumed()) {
        progress = Progress::from(*earlier);
    } else {
        progress.solid = noise(side, problem.channels(), context);
        matchColours(problem, progress.solid);
    }
    scales = std::min(scales, SteerablePyramid::largestScales({side, side}));
    for (const SliceGoal& goal : problem.goals())
        scales = std::min(scales, SteerablePyramid::largestScales(goal.exemplar.size()));
    PyramidMatcher matcher(problem, scales);
    const int iterations = problem.settings().iterations;
    for (int n = progress.iteration; n < iterations; ++n) {
        const double change = matcher.step(progress.solid);
        matchColours(problem, progress.solid);
        context.curve(TR("Change"), change);
        context.progress((n + 1.0) / iterations);
        problem.show(progress.solid);
        progress.iteration = n + 1;
        context.checkpoint(std::chrono::seconds(30), [&] { return progress.bytes(); });
    }
    return std::move(progress.solid);
}

} // namespace texloom::solid_optimise
