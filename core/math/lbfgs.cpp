#include "core/math/lbfgs.h"

#include "core/base/wide_vectors.h"
#include "core/math/byte_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace texloom {

namespace {

constexpr double kDecrease = 1e-4, kSlope = 0.9, kLeastCurvature = 1e-10;
constexpr int kMostProbes = 25;

/// The inner product, in eight sums.
TEXLOOM_WIDE_VECTORS double product(const float* a, const float* b, std::size_t count) {
    double sums[8] = {};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8)
        for (std::size_t k = 0; k < 8; ++k)
            sums[k] += static_cast<double>(a[i + k]) * static_cast<double>(b[i + k]);
    for (; i < count; ++i)
        sums[0] += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

double product(const std::vector<float>& a, const std::vector<float>& b) {
    return product(a.data(), b.data(), a.size());
}

TEXLOOM_WIDE_VECTORS void addScaled(float* to, float scale, const float* what, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        to[i] += scale * what[i];
}

/// Where the cubic through two points with these values and slopes is least, within bounds; their middle if
/// it has no least place.
template <class Probe> double cubicLeast(const Probe& a, const Probe& b, double low, double high) {
    const double d1 = a.slope + b.slope - 3 * (a.value - b.value) / (a.length - b.length);
    const double square = d1 * d1 - a.slope * b.slope;
    if (!(square >= 0))
        return (low + high) / 2;
    const double d2 = std::sqrt(square);
    const double least =
        a.length <= b.length
            ? b.length - (b.length - a.length) * ((b.slope + d2 - d1) / (b.slope - a.slope + 2 * d2))
            : a.length - (a.length - b.length) * ((a.slope + d2 - d1) / (a.slope - b.slope + 2 * d2));
    return std::isfinite(least) ? std::clamp(least, low, high) : (low + high) / 2;
}

} // namespace

Lbfgs::Lbfgs(std::vector<float> start, int history)
    : m_history(history), m_value(std::numeric_limits<double>::infinity()), m_x(std::move(start)),
      m_gradient(m_x.size()), m_probeX(m_x.size()), m_probeGradient(m_x.size()) {}

/// − H g by the two loops of algorithm 7.4.
std::vector<float> Lbfgs::direction() const {
    std::vector<float> q(m_gradient.size());
    std::transform(m_gradient.begin(), m_gradient.end(), q.begin(), [](float g) { return -g; });
    std::vector<double> shares(m_pairs.size());
    for (std::size_t i = m_pairs.size(); i-- > 0;) {
        shares[i] = product(m_pairs[i].step, q) / m_pairs[i].product;
        addScaled(q.data(), static_cast<float>(-shares[i]), m_pairs[i].change.data(), q.size());
    }
    if (!m_pairs.empty()) {
        const Pair& last = m_pairs.back();
        const auto scale = static_cast<float>(last.product / product(last.change, last.change));
        for (float& value : q)
            value *= scale;
    }
    for (std::size_t i = 0; i < m_pairs.size(); ++i) {
        const double back = product(m_pairs[i].change, q) / m_pairs[i].product;
        addScaled(q.data(), static_cast<float>(shares[i] - back), m_pairs[i].step.data(), q.size());
    }
    return q;
}

Lbfgs::Probe Lbfgs::probe(const Objective& objective, const std::vector<float>& along, double length) {
    m_probeX = m_x;
    addScaled(m_probeX.data(), static_cast<float>(length), along.data(), along.size());
    const double value = objective(m_probeX, m_probeGradient);
    return {length, value, product(m_probeGradient, along)};
}

/// Algorithm 3.5: lengthens the step until it brackets one that suits. @return the probe that was taken last,
/// whose x is in m_probeX; its value is not lower than now if none suits.
Lbfgs::Probe Lbfgs::search(const Objective& objective, const std::vector<float>& along, double first,
                           double slope) {
    Probe before{0, m_value, slope};
    double length = first;
    for (int probes = 1;; ++probes) {
        const Probe now = probe(objective, along, length);
        const bool tooHigh = !std::isfinite(now.value) || now.value > m_value + kDecrease * length * slope ||
                             (probes > 1 && now.value >= before.value);
        if (tooHigh)
            return narrowed(objective, along, before, now, slope, probes);
        if (std::abs(now.slope) <= -kSlope * slope || probes >= kMostProbes)
            return now;
        if (now.slope >= 0)
            return narrowed(objective, along, now, before, slope, probes);
        length = cubicLeast(before, now, length + 0.01 * (length - before.length), 10 * length);
        before = now;
    }
}

/// Algorithm 3.6: narrows a bracket, whose `low` end has the lower value, until a step suits.
Lbfgs::Probe Lbfgs::narrowed(const Objective& objective, const std::vector<float>& along, Probe low,
                             Probe high, double slope, int probes) {
    Probe now = high;
    for (; probes < kMostProbes; ++probes) {
        const double width = std::abs(high.length - low.length);
        if (width * std::abs(slope) < 1e-12 * std::max(1e-30, std::abs(m_value)))
            break;
        // Away from the ends, so that the bracket shrinks.
        const double left = std::min(low.length, high.length) + 0.1 * width;
        const double length =
            std::isfinite(high.value) ? cubicLeast(low, high, left, left + 0.8 * width) : left + 0.4 * width;
        now = probe(objective, along, length);
        if (!std::isfinite(now.value) || now.value > m_value + kDecrease * length * slope ||
            now.value >= low.value) {
            high = now;
            continue;
        }
        if (std::abs(now.slope) <= -kSlope * slope)
            return now;
        if (now.slope * (high.length - low.length) >= 0)
            high = low;
        low = now;
    }
    if (now.length != low.length && low.length > 0)
        now = probe(objective, along, low.length);
    return now;
}

void Lbfgs::remember(const std::vector<float>& oldGradient, const std::vector<float>& along, double length) {
    Pair pair;
    if (static_cast<int>(m_pairs.size()) == m_history) {
        pair = std::move(m_pairs.front());
        m_pairs.pop_front();
    }
    pair.step.resize(along.size());
    pair.change.resize(along.size());
    const auto scale = static_cast<float>(length);
    for (std::size_t i = 0; i < along.size(); ++i) {
        pair.step[i] = scale * along[i];
        pair.change[i] = m_gradient[i] - oldGradient[i];
    }
    pair.product = product(pair.step, pair.change);
    if (pair.product >
        kLeastCurvature * std::sqrt(product(pair.step, pair.step) * product(pair.change, pair.change)))
        m_pairs.push_back(std::move(pair));
}

bool Lbfgs::step(const Objective& objective) {
    if (!std::isfinite(m_value))
        m_value = objective(m_x, m_gradient);
    const std::vector<float> along = direction();
    const double slope = product(m_gradient, along);
    if (!(slope < 0))
        return false;
    double first = 1;
    if (m_pairs.empty()) {
        double sum = 0;
        for (const float g : m_gradient)
            sum += static_cast<double>(std::abs(g));
        first = std::min(1.0, 1 / sum);
    }
    const Probe found = search(objective, along, first, slope);
    if (!(found.value < m_value)) {
        if (m_pairs.empty())
            return false;
        // What was learned of the curvature does not hold here: once more from steepest descent.
        m_pairs.clear();
        return true;
    }
    std::swap(m_x, m_probeX);
    std::swap(m_gradient, m_probeGradient); // now the one before
    m_value = found.value;
    remember(m_probeGradient, along, found.length);
    return true;
}

std::string Lbfgs::state() const {
    StateWriter to;
    to.add(m_x);
    to.add(m_gradient);
    to.add(m_value);
    to.add(static_cast<std::uint64_t>(m_pairs.size()));
    for (const Pair& pair : m_pairs) {
        to.add(pair.step);
        to.add(pair.change);
        to.add(pair.product);
    }
    return to.take();
}

void Lbfgs::takeUp(std::string_view state) {
    StateReader from(state);
    std::vector<float> x = from.floats(), gradient = from.floats();
    if (x.size() != m_x.size() || gradient.size() != x.size())
        fail(TR("The checkpoint does not suit this run: start again without --resume."));
    m_x = std::move(x);
    m_gradient = std::move(gradient);
    m_value = from.number<double>();
    const auto count = from.number<std::uint64_t>();
    m_pairs.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
        Pair pair;
        pair.step = from.floats();
        pair.change = from.floats();
        pair.product = from.number<double>();
        m_pairs.push_back(std::move(pair));
    }
}

void Adam::step(std::span<const float> gradient, double rate) {
    constexpr double kMeanFades = 0.9, kSquareFades = 0.999, kLeast = 1e-8;
    ++m_steps;
    const double mean = 1 - std::pow(kMeanFades, m_steps), square = 1 - std::pow(kSquareFades, m_steps);
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const auto g = static_cast<double>(gradient[i]);
        const double newMean = kMeanFades * static_cast<double>(m_mean[i]) + (1 - kMeanFades) * g;
        const double newSquare = kSquareFades * static_cast<double>(m_square[i]) + (1 - kSquareFades) * g * g;
        m_mean[i] = static_cast<float>(newMean);
        m_square[i] = static_cast<float>(newSquare);
        m_x[i] -= static_cast<float>(rate * (newMean / mean) / (std::sqrt(newSquare / square) + kLeast));
    }
}

std::string Adam::state() const {
    StateWriter to;
    to.add(m_x);
    to.add(m_mean);
    to.add(m_square);
    to.add(m_steps);
    return to.take();
}

void Adam::takeUp(std::string_view state) {
    StateReader from(state);
    std::vector<float> x = from.floats(), mean = from.floats(), square = from.floats();
    if (x.size() != m_x.size() || mean.size() != x.size() || square.size() != x.size())
        fail(TR("The checkpoint does not suit this run: start again without --resume."));
    m_x = std::move(x);
    m_mean = std::move(mean);
    m_square = std::move(square);
    m_steps = from.number<int>();
}

} // namespace texloom
