#include "core/methods/portilla_simoncelli/correlations.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::portilla_simoncelli {

namespace {

using Complex = SteerablePyramid::Complex;

/// Eigenvalues below this share of the largest count as rounding.
constexpr double kLeastShare = 1e-7;

/// f(eigenvalue) in place of every eigenvalue, those below the least share left out or raised to it.
template <class Function>
Eigen::MatrixXd spectralMap(const Eigen::MatrixXd& symmetric, const Function& function) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    const double least = kLeastShare * std::max(0.0, solver.eigenvalues().maxCoeff());
    const Eigen::VectorXd values =
        solver.eigenvalues().unaryExpr([&](double value) { return value > least ? function(value) : 0.0; });
    return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

double root(double value) {
    return std::sqrt(value);
}
double inverse(double value) {
    return 1 / value;
}
double inverseRoot(double value) {
    return 1 / std::sqrt(value);
}

/// Sum of products, kept in lanes because a single running one does not vectorise.
double dot(const float* a, const float* b, std::size_t count) {
    constexpr std::size_t kLanes = 16;
    std::array<float, kLanes> sums{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            sums[lane] += a[i + lane] * b[i + lane];
    double sum = 0;
    for (; i < count; ++i)
        sum += static_cast<double>(a[i] * b[i]);
    for (const float lane : sums)
        sum += static_cast<double>(lane);
    return sum;
}

/// The value of a lag in a matrix that holds one of each pair of opposite lags.
double lagAt(const Eigen::MatrixXd& lags, int dx, int dy) {
    const auto reach = static_cast<int>(lags.rows()) - 1;
    return dy < 0 ? lags(-dy, reach - dx) : lags(dy, reach + dx);
}

struct Lag {
    int dx, dy;
};

/// One of each pair of opposite lags, (0, 0) first.
std::vector<Lag> halfPlane(int reach) {
    std::vector<Lag> lags;
    for (int dy = 0; dy <= reach; ++dy)
        for (int dx = dy == 0 ? 0 : -reach; dx <= reach; ++dx)
            lags.push_back({dx, dy});
    return lags;
}

} // namespace

Eigen::MatrixXd leastMap(const Eigen::MatrixXd& current, const Eigen::MatrixXd& wanted) {
    const Eigen::MatrixXd straight = spectralMap(current, root), back = spectralMap(current, inverseRoot);
    return back * spectralMap(straight * wanted * straight, root) * back;
}

Mixing mixingTo(const Eigen::MatrixXd& xx, const Eigen::MatrixXd& xy, const Eigen::MatrixXd& yy,
                const Eigen::MatrixXd& wantedXx, const Eigen::MatrixXd& wantedXy) {
    if (yy.size() == 0)
        return {leastMap(xx, wantedXx), Eigen::MatrixXd(xx.rows(), 0)};
    const Eigen::MatrixXd solved = spectralMap(yy, inverse);
    const Eigen::MatrixXd present = xy * solved, wished = wantedXy * solved;
    const Eigen::MatrixXd own =
        leastMap(xx - present * xy.transpose(), wantedXx - wished * wantedXy.transpose());
    return {own, wished - own * present};
}

Autocorrelator::Autocorrelator(const SteerablePyramid& pyramid, int scale, int reach)
    : m_pyramid(pyramid), m_scale(scale), m_reach(reach) {
    const auto height = static_cast<std::size_t>(pyramid.size(scale).height);
    for (int dy = 0; dy <= 2 * reach; ++dy) {
        m_cosines.emplace_back(height);
        m_sines.emplace_back(height);
        for (std::size_t row = 0; row < height; ++row) {
            const double angle = dy * pyramid.frequencyY(scale, static_cast<int>(row));
            m_cosines.back()[row] = static_cast<float>(std::cos(angle));
            m_sines.back()[row] = static_cast<float>(std::sin(angle));
        }
    }
    m_cosinesX.resize(2 * reach + 1, pyramid.fft(scale).columns());
    m_sinesX.resize(2 * reach + 1, pyramid.fft(scale).columns());
    for (int column = 0; column < pyramid.fft(scale).columns(); ++column)
        for (int dx = 0; dx <= 2 * reach; ++dx) {
            m_cosinesX(dx, column) = std::cos(dx * pyramid.frequencyX(scale, column));
            m_sinesX(dx, column) = std::sin(dx * pyramid.frequencyX(scale, column));
        }
}

/// How many bins of the whole spectrum a bin of the half spectrum stands for.
double Autocorrelator::weight(int column) const {
    return column == 0 || 2 * column == m_pyramid.size(m_scale).width ? 1 : 2;
}

double Autocorrelator::power(const Complex* spectrum, const Check& check) const {
    const RealFft2d& fft = m_pyramid.fft(m_scale);
    double sum = 0;
    for (int column = 0; column < fft.columns(); ++column) {
        check();
        const auto* values = reinterpret_cast<const float*>(spectrum + column * fft.columnStride());
        sum += weight(column) * dot(values, values, 2 * static_cast<std::size_t>(fft.size().height));
    }
    return sum;
}

Eigen::MatrixXd Autocorrelator::measure(const Complex* spectrum, const Check& check) const {
    const RealFft2d& fft = m_pyramid.fft(m_scale);
    const auto height = static_cast<std::size_t>(fft.size().height);
    const int reach = 2 * m_reach;
    Eigen::MatrixXd lags = Eigen::MatrixXd::Zero(reach + 1, 2 * reach + 1);
    std::vector<float> powers(height);
    for (int column = 0; column < fft.columns(); ++column) {
        check();
        const auto* bins = reinterpret_cast<const float*>(spectrum + column * fft.columnStride());
        for (std::size_t row = 0; row < height; ++row)
            powers[row] = bins[2 * row] * bins[2 * row] + bins[2 * row + 1] * bins[2 * row + 1];
        for (int dy = 0; dy <= reach; ++dy) {
            const auto nth = static_cast<std::size_t>(dy);
            const double even = weight(column) * dot(powers.data(), m_cosines[nth].data(), height);
            const double odd = weight(column) * dot(powers.data(), m_sines[nth].data(), height);
            lags(dy, reach) += even;
            for (int dx = 1; dx <= reach; ++dx) {
                const double both = even * m_cosinesX(dx, column), difference = odd * m_sinesX(dx, column);
                lags(dy, reach + dx) += both - difference;
                lags(dy, reach - dx) += both + difference;
            }
        }
    }
    return lags;
}

Eigen::MatrixXd Autocorrelator::central(const Eigen::MatrixXd& lags, int reach) {
    const Eigen::Index whole = lags.rows() - 1;
    return lags.block(0, whole - reach, reach + 1, 2 * reach + 1);
}

/// Solves for the symmetric kernel whose convolution with the current autocorrelation gives the wanted one.
Eigen::MatrixXd Autocorrelator::filterFor(const Eigen::MatrixXd& current,
                                          const Eigen::MatrixXd& wanted) const {
    constexpr double kRidge = 1e-8;
    const std::vector<Lag> lags = halfPlane(m_reach);
    const auto count = static_cast<Eigen::Index>(lags.size());
    Eigen::MatrixXd system(count, count);
    Eigen::VectorXd values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Lag to = lags[static_cast<std::size_t>(i)];
        values(i) = lagAt(wanted, to.dx, to.dy);
        for (Eigen::Index j = 0; j < count; ++j) {
            const Lag by = lags[static_cast<std::size_t>(j)];
            system(i, j) = lagAt(current, to.dx - by.dx, to.dy - by.dy);
            if (j > 0)
                system(i, j) += lagAt(current, to.dx + by.dx, to.dy + by.dy);
        }
        system(i, i) += kRidge * lagAt(current, 0, 0);
    }
    const Eigen::VectorXd solution = system.partialPivLu().solve(values);
    Eigen::MatrixXd kernel = Eigen::MatrixXd::Zero(m_reach + 1, 2 * m_reach + 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Lag at = lags[static_cast<std::size_t>(i)];
        kernel(at.dy, m_reach + at.dx) = solution(i);
        if (at.dy == 0)
            kernel(0, m_reach - at.dx) = solution(i);
    }
    return kernel;
}

void Autocorrelator::impose(const Eigen::MatrixXd& current, const Eigen::MatrixXd& wanted, Complex* spectrum,
                            const Check& check) const {
    const double present = lagAt(current, 0, 0), variance = lagAt(wanted, 0, 0);
    if (!(present > 0))
        return;
    const Eigen::MatrixXd kernel = filterFor(current, central(wanted, m_reach));
    const RealFft2d& fft = m_pyramid.fft(m_scale);
    const auto height = static_cast<std::size_t>(fft.size().height);
    std::vector<float> gains(height);
    const bool sound = kernel.allFinite();
    for (int column = 0; column < fft.columns() && sound; ++column) {
        check();
        std::fill(gains.begin(), gains.end(), 0.0F);
        for (int dy = 0; dy <= m_reach; ++dy) {
            double even = kernel(dy, m_reach), odd = 0;
            for (int dx = 1; dx <= m_reach; ++dx) {
                const double right = kernel(dy, m_reach + dx), left = kernel(dy, m_reach - dx);
                even += (right + left) * m_cosinesX(dx, column);
                odd += (right - left) * m_sinesX(dx, column);
            }
            const auto c = static_cast<float>(dy == 0 ? even : 2 * even);
            const auto s = static_cast<float>(dy == 0 ? 0 : 2 * odd);
            const float* cosines = m_cosines[static_cast<std::size_t>(dy)].data();
            const float* sines = m_sines[static_cast<std::size_t>(dy)].data();
            for (std::size_t row = 0; row < height; ++row)
                gains[row] += c * cosines[row] - s * sines[row];
        }
        auto* bins = reinterpret_cast<float*>(spectrum + column * fft.columnStride());
        for (std::size_t row = 0; row < height; ++row) {
            const float gain = std::sqrt(std::abs(gains[row]));
            bins[2 * row] *= gain;
            bins[2 * row + 1] *= gain;
        }
    }
    const double now = power(spectrum, check);
    const auto scale = static_cast<float>(now > 0 ? std::sqrt(variance / now) : 0);
    for (int column = 0; column < fft.columns(); ++column) {
        check();
        auto* bins = reinterpret_cast<float*>(spectrum + column * fft.columnStride());
        for (std::size_t i = 0; i < 2 * height; ++i)
            bins[i] *= scale;
    }
}

} // namespace texloom::portilla_simoncelli
