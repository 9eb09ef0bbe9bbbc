#include "core/math/anamorphosis.h"

#include "core/base/at.h"
#include "core/image/mirror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

/// Streams of random numbers, by what they are for.
constexpr std::uint32_t kShape = 0, kAcross = 1, kDown = 2;
/// After so many nodes the turbulence repeats, at the latest.
constexpr int kMostNodes = 256;
/// Nodes in one deviation of the Gaussian.
constexpr double kNodesInScale = 2;
constexpr double kLeastDeterminant = 0.1;
/// Where the knot of the affine kind lies.
constexpr double kFirstKnot = 0.3, kLastKnot = 0.7;

} // namespace

struct Anamorphosis::Weights {
    int first = 0; ///< number of the first node
    std::array<double, 4> value{}, slope{};

    Weights(double at, const Nodes& nodes) {
        const double place = at / nodes.spacing, floor = std::floor(place), t = place - floor, s = 1 - t;
        first = static_cast<int>(floor) - 1;
        value = {s * s * s / 6, (4 + 3 * t * t * (t - 2)) / 6, (4 + 3 * s * s * (s - 2)) / 6, t * t * t / 6};
        slope = {-s * s / 2, t * (1.5 * t - 2), -s * (1.5 * s - 2), t * t / 2};
        for (double& weight : slope)
            weight /= nodes.spacing;
    }
};

Anamorphosis::Anamorphosis(Size plane, const AnamorphosisOptions& options, Wrap wrap, const Random& random)
    : m_plane(plane), m_kind(options.kind), m_alongY(options.axis == AnamorphosisAxis::Y),
      m_amplitude(options.amplitude), m_frequency(options.frequency) {
    if (turbulent()) {
        m_columns = nodesFor(plane.width, options.scale, wrap.x);
        m_rows = nodesFor(plane.height, options.scale, wrap.y);
        makeTurbulence(options.scale, random);
        return;
    }
    m_signed = random.uniform(0, 0, kShape) < 0.5 ? -m_amplitude : m_amplitude;
    m_knot = kFirstKnot + (kLastKnot - kFirstKnot) * random.uniform(1, 0, kShape);
    if (m_alongY ? wrap.y : wrap.x)
        m_phase = 2 * std::numbers::pi * random.uniform(2, 0, kShape);
    m_leastDeterminant = 1 - m_amplitude;
}

double Anamorphosis::along(double at) const {
    // What is added comes last, so that without it nothing moves by a bit.
    const double t = at / length(), pi = std::numbers::pi;
    double move = 0;
    if (m_kind == AnamorphosisKind::Affine)
        move = t < m_knot ? m_signed * (1 - m_knot) * t : m_signed * m_knot * (1 - t);
    else if (m_kind == AnamorphosisKind::Parabola)
        move = m_signed * t * (1 - t);
    else
        move = m_signed / (2 * pi * m_frequency) *
               (std::sin(2 * pi * m_frequency * t + m_phase) - std::sin(m_phase));
    return at + length() * move;
}

double Anamorphosis::slope(double at) const {
    const double t = at / length();
    if (m_kind == AnamorphosisKind::Affine)
        return t < m_knot ? 1 + m_signed * (1 - m_knot) : 1 - m_signed * m_knot;
    if (m_kind == AnamorphosisKind::Parabola)
        return 1 + m_signed * (1 - 2 * t);
    return 1 + m_signed * std::cos(2 * std::numbers::pi * m_frequency * t + m_phase);
}

PlanePoint Anamorphosis::toSource(PlanePoint point) const {
    PlanePoint source;
    row(point.x, point.y, 1, &source, nullptr);
    return source;
}

Eigen::Matrix2d Anamorphosis::jacobian(PlanePoint point) const {
    PlanePoint source;
    Eigen::Matrix2d derivative;
    row(point.x, point.y, 1, &source, &derivative);
    return derivative;
}

void Anamorphosis::row(double x, double y, int count, PlanePoint* points, Eigen::Matrix2d* jacobians) const {
    if (!turbulent()) {
        const double movedY = m_alongY ? along(y) : y, slopeY = m_alongY ? slope(y) : 1;
        for (int i = 0; i < count; ++i) {
            const double at = x + i;
            points[i] = {m_alongY ? at : along(at), movedY};
            if (jacobians != nullptr)
                jacobians[i] << (m_alongY ? 1 : slope(at)), 0, 0, slopeY;
        }
        return;
    }
    const Weights down(y, m_rows);
    std::array<std::size_t, 4> lines{};
    for (int j = 0; j < 4; ++j)
        lines[static_cast<std::size_t>(j)] = node(0, down.first + j);
    // Sums down the lattice's columns serve all points between two of its nodes.
    std::array<double, 4> moveX{}, moveY{}, slopeX{}, slopeY{};
    int summed = -1;
    bool any = false;
    for (int i = 0; i < count; ++i) {
        const Weights across(x + i, m_columns);
        if (!any || across.first != summed) {
            any = true;
            summed = across.first;
            moveX = moveY = slopeX = slopeY = {};
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < 4; ++k) {
                    const std::size_t n =
                        lines[j] + static_cast<std::size_t>(
                                       repeated(across.first + static_cast<int>(k), m_columns.count));
                    moveX[k] += down.value[j] * m_moveX[n];
                    moveY[k] += down.value[j] * m_moveY[n];
                    slopeX[k] += down.slope[j] * m_moveX[n];
                    slopeY[k] += down.slope[j] * m_moveY[n];
                }
        }
        double dx = 0, dy = 0;
        Eigen::Matrix2d derivative = Eigen::Matrix2d::Identity();
        for (std::size_t k = 0; k < 4; ++k) {
            dx += across.value[k] * moveX[k];
            dy += across.value[k] * moveY[k];
            derivative(0, 0) += across.slope[k] * moveX[k];
            derivative(1, 0) += across.slope[k] * moveY[k];
            derivative(0, 1) += across.value[k] * slopeX[k];
            derivative(1, 1) += across.value[k] * slopeY[k];
        }
        points[i] = {x + i + dx, y + dy};
        if (jacobians != nullptr)
            jacobians[i] = derivative;
    }
}

Anamorphosis::Nodes Anamorphosis::nodesFor(int length, double scale, bool wraps) {
    const double spacing = scale / kNodesInScale;
    if (!wraps) {
        // Far enough beyond the border that both ends have little to do with each other.
        const int beyond = static_cast<int>(6 * kNodesInScale);
        return {std::min(kMostNodes, static_cast<int>(std::ceil(length / spacing)) + beyond), spacing};
    }
    const int nodes = std::max(1, static_cast<int>(std::lround(length / spacing)));
    const int times = (nodes + kMostNodes - 1) / kMostNodes, count = (nodes + times - 1) / times;
    return {count, static_cast<double>(length) / (times * count)};
}

std::size_t Anamorphosis::node(int x, int y) const {
    return static_cast<std::size_t>(repeated(y, m_rows.count)) * static_cast<std::size_t>(m_columns.count) +
           static_cast<std::size_t>(repeated(x, m_columns.count));
}

/// Blurs along one axis of the lattice, which closes.
void Anamorphosis::blur(std::vector<double>& values, bool alongY) const {
    const int radius = static_cast<int>(4 * kNodesInScale);
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i)
        weights.push_back(std::exp(-0.5 * i * i / (kNodesInScale * kNodesInScale)));
    const std::vector<double> from = values;
    for (int y = 0; y < m_rows.count; ++y)
        for (int x = 0; x < m_columns.count; ++x) {
            double sum = 0;
            for (int i = -radius; i <= radius; ++i)
                sum += weights[at(i + radius)] * from[alongY ? node(x, y + i) : node(x + i, y)];
            values[node(x, y)] = sum;
        }
}

/// Gives a field mean 0 and, at the nodes, deviation 1; all 0 if it does not vary.
void Anamorphosis::normalise(std::vector<double>& values) const {
    double sum = 0, squares = 0;
    for (const double value : values)
        sum += value;
    const double mean = sum / static_cast<double>(values.size());
    for (double& value : values)
        value -= mean;
    constexpr std::array<double, 3> kSpline{1.0 / 6, 4.0 / 6, 1.0 / 6};
    for (int y = 0; y < m_rows.count; ++y)
        for (int x = 0; x < m_columns.count; ++x) {
            double value = 0;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    value += kSpline[at(i + 1)] * kSpline[at(j + 1)] * values[node(x + i, y + j)];
            squares += value * value;
        }
    const double deviation = std::sqrt(squares / static_cast<double>(values.size()));
    constexpr double kNothing = 1e-9;
    for (double& value : values)
        value = deviation > kNothing ? value / deviation : 0;
}

std::vector<double> Anamorphosis::blurredNoise(const Random& random, std::uint32_t stream) const {
    std::vector<double> values(static_cast<std::size_t>(m_columns.count) *
                               static_cast<std::size_t>(m_rows.count));
    for (int y = 0; y < m_rows.count; ++y)
        for (int x = 0; x < m_columns.count; ++x)
            values[node(x, y)] = random.normal(x, y, stream);
    blur(values, false);
    blur(values, true);
    normalise(values);
    return values;
}

/// Cubic B-splines' derivatives are means of the differences of neighbouring coefficients: of three along the
/// axis, and of four lines of them.
std::vector<Anamorphosis::Bounds> Anamorphosis::bounds(double scale) const {
    struct Interval {
        double least = 1e300, most = -1e300;
        void add(double value) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    };
    const auto across = [&](const std::vector<double>& field, int x, int y) {
        Interval interval;
        for (int j = -1; j <= 2; ++j)
            for (int i = -1; i <= 1; ++i)
                interval.add((field[node(x + i + 1, y + j)] - field[node(x + i, y + j)]) * scale /
                             m_columns.spacing);
        return interval;
    };
    const auto down = [&](const std::vector<double>& field, int x, int y) {
        Interval interval;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 2; ++i)
                interval.add((field[node(x + i, y + j + 1)] - field[node(x + i, y + j)]) * scale /
                             m_rows.spacing);
        return interval;
    };
    std::vector<Bounds> bounds;
    for (int y = 0; y < m_rows.count; ++y)
        for (int x = 0; x < m_columns.count; ++x) {
            const Interval p = down(m_moveX, x, y), q = across(m_moveY, x, y);
            bounds.push_back(
                {across(m_moveX, x, y).least, down(m_moveY, x, y).least,
                 std::max({p.least * q.least, p.least * q.most, p.most * q.least, p.most * q.most})});
        }
    return bounds;
}

/// A lower bound of the determinant; 0 where either axis might turn round.
double Anamorphosis::least(const std::vector<Bounds>& bounds, double amplitude) {
    double least = 1;
    for (const Bounds& cell : bounds) {
        const double alongX = 1 + amplitude * cell.alongX, alongY = 1 + amplitude * cell.alongY;
        if (alongX <= 0 || alongY <= 0)
            return 0;
        least = std::min(least, alongX * alongY - amplitude * amplitude * cell.product);
    }
    return least;
}

void Anamorphosis::makeTurbulence(double scale, const Random& random) {
    m_moveX = blurredNoise(random, kAcross);
    m_moveY = blurredNoise(random, kDown);
    const std::vector<Bounds> cells = bounds(scale);
    double sound = 0, wanted = m_amplitude;
    constexpr int kSteps = 40;
    if (least(cells, wanted) > kLeastDeterminant)
        sound = wanted;
    for (int step = 0; step < kSteps && sound < m_amplitude; ++step) {
        const double middle = 0.5 * (sound + wanted);
        (least(cells, middle) > kLeastDeterminant ? sound : wanted) = middle;
    }
    m_amplitude = sound;
    m_leastDeterminant = least(cells, sound);
    for (std::vector<double>* field : {&m_moveX, &m_moveY})
        for (double& value : *field)
            value *= sound * scale;
}

std::uint64_t Anamorphosis::bytesFor() {
    return static_cast<std::uint64_t>(kMostNodes) * kMostNodes *
           (4 * sizeof(double) + 2 * sizeof(Bounds)); // coefficients, their copies, bounds as they grow
}

} // namespace texloom
