#include "core/math/poisson.h"

#include "core/math/fft.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

struct Step {
    int x, y;
};
constexpr Step kSteps[] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

bool inside(int x, int y, Size size) {
    return x >= 0 && y >= 0 && x < size.width && y < size.height;
}

} // namespace

struct PoissonRegion::Factors {
    Size size;
    std::vector<int> number;  ///< by pixel: of the equation, or −1
    std::vector<Step> pixels; ///< by equation
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;

    int numberAt(int x, int y) const {
        return number[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                      static_cast<std::size_t>(x)];
    }
};

PoissonRegion::PoissonRegion(const std::vector<std::uint8_t>& unknown, Size size)
    : m_factors(std::make_unique<Factors>()) {
    Factors& f = *m_factors;
    f.size = size;
    for (std::size_t i = 0; i < unknown.size(); ++i) {
        f.number.push_back(unknown[i] != 0 ? static_cast<int>(f.pixels.size()) : -1);
        if (unknown[i] != 0)
            f.pixels.push_back({static_cast<int>(i) % size.width, static_cast<int>(i) / size.width});
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [x, y] : f.pixels) {
        const int row = f.numberAt(x, y);
        int neighbours = 0;
        for (const Step& step : kSteps) {
            if (!inside(x + step.x, y + step.y, size))
                continue;
            ++neighbours;
            if (const int column = f.numberAt(x + step.x, y + step.y); column >= 0)
                entries.emplace_back(row, column, -1.0);
        }
        entries.emplace_back(row, row, neighbours);
    }
    const auto count = static_cast<Eigen::Index>(f.pixels.size());
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    f.solver.compute(matrix);
}

PoissonRegion::~PoissonRegion() = default;
PoissonRegion::PoissonRegion(PoissonRegion&&) noexcept = default;
PoissonRegion& PoissonRegion::operator=(PoissonRegion&&) noexcept = default;

void PoissonRegion::solve(const PlaneView& divergence, PlaneSpan values) const {
    const Factors& f = *m_factors;
    Eigen::VectorXd right(static_cast<Eigen::Index>(f.pixels.size()));
    for (std::size_t i = 0; i < f.pixels.size(); ++i) {
        const auto [x, y] = f.pixels[i];
        double sum = -static_cast<double>(divergence(x, y));
        for (const Step& step : kSteps)
            if (inside(x + step.x, y + step.y, f.size) && f.numberAt(x + step.x, y + step.y) < 0)
                sum += static_cast<double>(values(x + step.x, y + step.y));
        right[static_cast<Eigen::Index>(i)] = sum;
    }
    const Eigen::VectorXd solution = f.solver.solve(right);
    for (std::size_t i = 0; i < f.pixels.size(); ++i)
        values(f.pixels[i].x, f.pixels[i].y) = static_cast<float>(solution[static_cast<Eigen::Index>(i)]);
}

namespace {

/// The equations of a region without its matrix, and the factor L of Gustafsson's modified incomplete
/// factorisation, of which only the diagonal's inverse is kept: all other entries are −1.
class IterativeRegion {
public:
    IterativeRegion(const std::vector<std::uint8_t>& unknown, Size size, const std::function<void()>& check);

    /// @param progress told of the share of the digits that are right.
    void solve(const PlaneView& divergence, PlaneSpan values, const std::function<void(double)>& progress);

private:
    using Vector = std::vector<double>;

    struct Equation {
        int x, y;
        int left = -1, up = -1, right = -1, down = -1; ///< the neighbours' equations; −1: given or outside
        int neighbours = 0;
    };

    void factorise();
    /// to = A from
    void multiply(const Vector& from, Vector& to) const;
    /// to = (L Lᵗ)⁻¹ from
    void precondition(const Vector& from, Vector& to) const;
    template <class Visit> void each(Visit visit) const;
    double product(const Vector& a, const Vector& b) const;

    Size m_size;
    const std::function<void()>& m_check;
    std::vector<Equation> m_equations;
    Vector m_inverse;
};

constexpr std::size_t kBetweenChecks = 1 << 16;

IterativeRegion::IterativeRegion(const std::vector<std::uint8_t>& unknown, Size size,
                                 const std::function<void()>& check)
    : m_size(size), m_check(check) {
    std::vector<int> above(static_cast<std::size_t>(size.width), -1), row = above;
    for (int y = 0; y < size.height; ++y) {
        check();
        std::fill(row.begin(), row.end(), -1);
        for (int x = 0; x < size.width; ++x) {
            const auto column = static_cast<std::size_t>(x);
            if (unknown[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + column] == 0)
                continue;
            const int own = static_cast<int>(m_equations.size());
            row[column] = own;
            Equation equation{x, y};
            for (const Step& step : kSteps)
                equation.neighbours += inside(x + step.x, y + step.y, size) ? 1 : 0;
            equation.left = x > 0 ? row[column - 1] : -1;
            equation.up = above[column];
            if (equation.left >= 0)
                m_equations[static_cast<std::size_t>(equation.left)].right = own;
            if (equation.up >= 0)
                m_equations[static_cast<std::size_t>(equation.up)].down = own;
            m_equations.push_back(equation);
        }
        above.swap(row);
    }
    factorise();
}

template <class Visit> void IterativeRegion::each(Visit visit) const {
    for (std::size_t i = 0; i < m_equations.size(); ++i) {
        if (i % kBetweenChecks == 0)
            m_check();
        visit(i, m_equations[i]);
    }
}

void IterativeRegion::factorise() {
    // Nearly all of what the factor leaves out goes to the diagonal, which keeps it positive.
    constexpr double kModified = 0.97, kSafe = 0.25;
    m_inverse.assign(m_equations.size(), 0);
    each([&](std::size_t i, const Equation& equation) {
        double diagonal = equation.neighbours;
        const auto eliminate = [&](int before, int other) {
            const double share = m_inverse[static_cast<std::size_t>(before)];
            diagonal -= share * share * (1 + (other >= 0 ? kModified : 0));
        };
        if (equation.left >= 0)
            eliminate(equation.left, m_equations[static_cast<std::size_t>(equation.left)].down);
        if (equation.up >= 0)
            eliminate(equation.up, m_equations[static_cast<std::size_t>(equation.up)].right);
        m_inverse[i] = 1 / std::sqrt(diagonal < kSafe * equation.neighbours ? equation.neighbours : diagonal);
    });
}

void IterativeRegion::multiply(const Vector& from, Vector& to) const {
    each([&](std::size_t i, const Equation& equation) {
        double sum = equation.neighbours * from[i];
        for (const int neighbour : {equation.left, equation.up, equation.right, equation.down})
            if (neighbour >= 0)
                sum -= from[static_cast<std::size_t>(neighbour)];
        to[i] = sum;
    });
}

void IterativeRegion::precondition(const Vector& from, Vector& to) const {
    const auto term = [&](int neighbour) {
        const auto n = static_cast<std::size_t>(neighbour);
        return neighbour < 0 ? 0.0 : m_inverse[n] * to[n];
    };
    each([&](std::size_t i, const Equation& equation) {
        to[i] = (from[i] + term(equation.left) + term(equation.up)) * m_inverse[i];
    });
    for (std::size_t left = m_equations.size(); left > 0; --left) {
        const std::size_t i = left - 1;
        if (i % kBetweenChecks == 0)
            m_check();
        const auto after = [&](int neighbour) {
            return neighbour < 0 ? 0.0 : to[static_cast<std::size_t>(neighbour)];
        };
        to[i] = (to[i] + m_inverse[i] * (after(m_equations[i].right) + after(m_equations[i].down))) *
                m_inverse[i];
    }
}

double IterativeRegion::product(const Vector& a, const Vector& b) const {
    double sum = 0;
    each([&](std::size_t i, const Equation&) { sum += a[i] * b[i]; });
    return sum;
}

void IterativeRegion::solve(const PlaneView& divergence, PlaneSpan values,
                            const std::function<void(double)>& progress) {
    constexpr int kMostSteps = 20'000;
    constexpr double kPrecision = 1e-7;
    const std::size_t count = m_equations.size();
    Vector f(count), residual(count), way(count), step(count), image(count);
    double largest = 0;
    each([&](std::size_t i, const Equation& equation) {
        f[i] = static_cast<double>(values(equation.x, equation.y));
        largest = std::max(largest, std::abs(f[i]));
    });
    multiply(f, image);
    each([&](std::size_t i, const Equation& equation) {
        double right = -static_cast<double>(divergence(equation.x, equation.y));
        const int neighbours[] = {equation.left, equation.right, equation.up, equation.down};
        for (std::size_t k = 0; k < 4; ++k) {
            const int x = equation.x + kSteps[k].x, y = equation.y + kSteps[k].y;
            if (neighbours[k] < 0 && inside(x, y, m_size)) {
                right += static_cast<double>(values(x, y));
                largest = std::max(largest, std::abs(static_cast<double>(values(x, y))));
            }
        }
        residual[i] = right - image[i];
    });
    const auto worst = [&] {
        double most = 0;
        each([&](std::size_t i, const Equation&) { most = std::max(most, std::abs(residual[i])); });
        return most;
    };
    const double first = worst(), wanted = kPrecision * std::max(largest, 1e-30);
    double now = first, energy = 0;
    for (int n = 0; n < kMostSteps && now > wanted; ++n) {
        precondition(residual, image);
        const double next = product(residual, image);
        const double share = n == 0 ? 0 : next / energy;
        energy = next;
        each([&](std::size_t i, const Equation&) { way[i] = image[i] + share * way[i]; });
        multiply(way, step);
        const double length = energy / product(way, step);
        each([&](std::size_t i, const Equation&) {
            f[i] += length * way[i];
            residual[i] -= length * step[i];
        });
        now = worst();
        progress(std::clamp(std::log(first / std::max(now, 1e-300)) / std::log(first / wanted), 0.0, 1.0));
    }
    for (std::size_t i = 0; i < count; ++i)
        values(m_equations[i].x, m_equations[i].y) = static_cast<float>(f[i]);
}

} // namespace

void solvePoisson(const std::vector<std::uint8_t>& unknown, const ImageView& divergence, Image& values,
                  const std::function<void(double)>& progress) {
    double done = 0;
    const std::function<void()> check = [&] { progress(done); };
    IterativeRegion region(unknown, values.size(), check);
    for (int c = 0; c < divergence.channels; ++c)
        region.solve(divergence.plane(c), values.plane(c), [&](double share) {
            done = std::max(done, (c + share) / divergence.channels);
            progress(done);
        });
}

namespace {

/// One correction of f: mirrored to twice the size, the cosine transform is a Fourier transform.
class CosineSolver {
public:
    explicit CosineSolver(Size size)
        : m_size(size), m_fft({2 * size.width, 2 * size.height}), m_image(m_fft.imageSize()),
          m_spectrum(m_fft.spectrumSize()) {}

    /// Adds the solution for `right` to f.
    void correct(const std::vector<double>& right, std::vector<double>& f) {
        mirror(right);
        m_fft.forwardRows(m_image.data(), m_fft.size().height, m_spectrum.data(), [] {});
        m_fft.forwardColumns(m_spectrum.data(), 0, m_fft.columns());
        divide();
        m_fft.backwardColumns(m_spectrum.data(), 0, m_fft.columns());
        m_fft.backwardRows(m_spectrum.data(), m_size.height, m_image.data(), [] {});
        const double scale = 1 / static_cast<double>(m_fft.size().area());
        for (int y = 0; y < m_size.height; ++y)
            for (int x = 0; x < m_size.width; ++x)
                f[at(x, y)] += scale * static_cast<double>(m_image.data()[y * m_fft.rowStride() + x]);
    }

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
               static_cast<std::size_t>(x);
    }

private:
    void mirror(const std::vector<double>& right) {
        for (int y = 0; y < 2 * m_size.height; ++y)
            for (int x = 0; x < 2 * m_size.width; ++x)
                m_image.data()[y * m_fft.rowStride() + x] = static_cast<float>(
                    right[at(std::min(x, 2 * m_size.width - 1 - x), std::min(y, 2 * m_size.height - 1 - y))]);
    }
    void divide() {
        for (int k = 0; k < m_fft.columns(); ++k)
            for (int l = 0; l < m_fft.size().height; ++l) {
                const double eigenvalue = 2 * std::cos(std::numbers::pi * k / m_size.width) +
                                          2 * std::cos(std::numbers::pi * l / m_size.height) - 4;
                auto& value = m_spectrum.data()[k * m_fft.columnStride() + l];
                value = k == 0 && l == 0 ? 0.0F : value / static_cast<float>(eigenvalue);
            }
    }

    Size m_size;
    RealFft2d m_fft;
    FftBuffer<float> m_image;
    FftBuffer<std::complex<float>> m_spectrum;
};

} // namespace

Image solvePoisson(const ImageView& divergence, const std::vector<double>& means) {
    const Size size = divergence.size();
    Image result(size, divergence.channels);
    CosineSolver solver(size);
    const auto area = static_cast<std::size_t>(size.area());
    for (int c = 0; c < divergence.channels; ++c) {
        std::vector<double> f(area, 0.0), residual(area);
        // Transforms are in single precision; what is left of the residual is solved for again.
        for (int round = 0; round < 3; ++round) {
            double mean = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    double left = static_cast<double>(divergence(x, y, c));
                    for (const Step& step : kSteps)
                        if (inside(x + step.x, y + step.y, size))
                            left -= f[solver.at(x + step.x, y + step.y)] - f[solver.at(x, y)];
                    residual[solver.at(x, y)] = left;
                    mean += left / static_cast<double>(area);
                }
            for (double& value : residual)
                value -= mean;
            solver.correct(residual, f);
        }
        double mean = 0;
        for (const double value : f)
            mean += value / static_cast<double>(area);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                result(x, y, c) =
                    static_cast<float>(f[solver.at(x, y)] - mean + means[static_cast<std::size_t>(c)]);
    }
    return result;
}

} // namespace texloom
