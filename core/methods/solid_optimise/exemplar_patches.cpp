#include "core/methods/solid_optimise/exemplar_patches.h"

#include "core/base/at.h"
#include "core/base/wide_vectors.h"
#include "core/match/tap_sums.h"
#include "core/math/pca.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>

namespace texloom::solid_optimise {

namespace {

constexpr int kMostAxes = 32, kLanes = 8; ///< components come in whole lanes, the last ones 0
constexpr int kSamples = 4096;            ///< patches that components are learnt from
constexpr int kCompared = 6000;           ///< patches among which those are found that are alike
constexpr double kShare = 0.95;           ///< of the variance

TEXLOOM_WIDE_VECTORS
float squaredLanes(const float* a, const float* b, int count) {
    float lanes[kLanes] = {};
    for (int i = 0; i < count; i += kLanes)
        for (int lane = 0; lane < kLanes; ++lane)
            lanes[lane] += (a[i + lane] - b[i + lane]) * (a[i + lane] - b[i + lane]);
    return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

} // namespace

ExemplarPatches::ExemplarPatches(Image exemplar, int patch, JobContext& context)
    : m_exemplar(std::move(exemplar)), m_positions{m_exemplar.width() - patch + 1,
                                                   m_exemplar.height() - patch + 1},
      m_length(m_exemplar.channels() * patch * patch) {
    for (int y = 0; y < m_exemplar.height(); ++y)
        for (int x = 0; x < m_exemplar.width(); ++x)
            for (int c = 0; c < m_exemplar.channels(); ++c)
                m_colours.push_back(m_exemplar(x, y, c));
    learnAxes(patch, context);
    describe(patch, context);
    findAlike(context);
}

void ExemplarPatches::learnAxes(int patch, JobContext& context) {
    const int step = std::max(1, count() / kSamples);
    std::vector<double> vectors;
    for (int n = 0; n < count(); n += step) {
        const int left = n % m_positions.width, top = n / m_positions.width;
        for (int c = 0; c < m_exemplar.channels(); ++c)
            for (int j = 0; j < patch; ++j)
                for (int i = 0; i < patch; ++i)
                    vectors.push_back(static_cast<double>(m_exemplar(left + i, top + j, c)));
    }
    context.check();
    const int most = std::min(kMostAxes, m_length);
    const PrincipalAxes principal = principalAxes(vectors, m_length, most);
    double whole = 0, sum = 0;
    for (const double variance : principal.variances)
        whole += std::max(0.0, variance);
    int wanted = 0;
    while (wanted < most && sum < kShare * whole)
        sum += std::max(0.0, principal.variances[at(wanted++)]);
    m_axes = std::max(kLanes, (wanted + kLanes - 1) / kLanes * kLanes);
    for (int k = 0; k < m_axes; ++k) {
        double offset = 0;
        for (int i = 0; i < m_length; ++i) {
            const double weight = k < wanted ? principal.axis(k)[at(i)] : 0;
            m_weights.push_back(static_cast<float>(weight));
            offset += weight * principal.mean[at(i)];
        }
        m_offsets.push_back(static_cast<float>(offset));
    }
}

void ExemplarPatches::describe(int patch, JobContext& context) {
    m_descriptors.assign(at(count()) * at(m_axes), 0.0F);
    context.parallel(0, m_positions.height, [&](int y) {
        std::vector<const float*> taps;
        for (int c = 0; c < m_exemplar.channels(); ++c)
            for (int j = 0; j < patch; ++j)
                for (int i = 0; i < patch; ++i)
                    taps.push_back(m_exemplar.view().plane(c).row(y + j) + i);
        std::vector<float> row(at(m_positions.width));
        for (int k = 0; k < m_axes; ++k) {
            sumTaps(taps.data(), axis(k), m_length, m_positions.width, row.data());
            for (int x = 0; x < m_positions.width; ++x)
                m_descriptors[(at(y) * row.size() + at(x)) * at(m_axes) + at(k)] = row[at(x)] - offset(k);
        }
    });
}

void ExemplarPatches::findAlike(JobContext& context) {
    const int step = std::max(1, count() / kCompared) | 1;
    m_alike.assign(at(count()) * kAlike, 0);
    context.parallel(0, count(), [&](int n) {
        std::array<std::pair<float, std::int32_t>, kAlike> best;
        best.fill({std::numeric_limits<float>::max(), n});
        const float* own = m_descriptors.data() + at(n) * at(m_axes);
        for (int other = n % step; other < count(); other += step) {
            // What lies next to it is found by going on from the neighbours.
            if (std::abs(other % m_positions.width - n % m_positions.width) < 2 &&
                std::abs(other / m_positions.width - n / m_positions.width) < 2)
                continue;
            const std::pair<float, std::int32_t> entry{distance(own, other), other};
            if (entry >= best.back())
                continue;
            best.back() = entry;
            std::sort(best.begin(), best.end());
        }
        for (std::size_t i = 0; i < best.size(); ++i)
            m_alike[at(n) * kAlike + i] = best[i].second;
    });
}

float ExemplarPatches::distance(const float* components, std::int32_t number) const {
    return squaredLanes(components, m_descriptors.data() + at(number) * at(m_axes), m_axes) /
           static_cast<float>(m_length);
}

std::int32_t ExemplarPatches::nearest(const float* components, float& best) const {
    std::int32_t found = 0;
    best = std::numeric_limits<float>::max();
    for (std::int32_t n = 0; n < count(); ++n)
        if (const float here = distance(components, n); here < best) {
            best = here;
            found = n;
        }
    return found;
}

} // namespace texloom::solid_optimise
