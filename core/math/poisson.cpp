#include "core/math/poisson.h"

#include "core/math/fft.h"
#include "core/math/multigrid.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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

void PoissonRegion::solve(std::span<const float> divergence, PlaneSpan values) const {
    const Factors& f = *m_factors;
    Eigen::VectorXd right(static_cast<Eigen::Index>(f.pixels.size()));
    for (std::size_t i = 0; i < f.pixels.size(); ++i) {
        const auto [x, y] = f.pixels[i];
        double sum = -static_cast<double>(divergence[i]);
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

/// Conjugate gradients on the equations of a region, preconditioned by a cycle over grids.
class IterativeRegion {
public:
    IterativeRegion(const std::vector<std::uint8_t>& unknown, Size size, const std::function<void()>& check);

    /// @param progress called with the share of the wanted digits that are correct.
    void solve(std::span<const float> divergence, PlaneSpan values,
               const std::function<void(double)>& progress);
    std::size_t count() const { return m_pixels.size(); }

private:
    using Vector = std::vector<double>;

    /// Calls visit(i) for every equation.
    template <class Visit> void each(Visit visit) const;
    double product(const Vector& a, const Vector& b) const;
    /// The right-hand side minus A f, and the largest known value.
    double begin(std::span<const float> divergence, const PlaneView& values);
    /// m_image = the cycle's solution for the residual
    void precondition();
    double worst() const;

    const std::function<void()>& m_check;
    std::vector<Multigrid::Pixel> m_pixels;
    std::optional<Multigrid> m_grids;
    Vector m_f, m_residual, m_way, m_image;
};

IterativeRegion::IterativeRegion(const std::vector<std::uint8_t>& unknown, Size size,
                                 const std::function<void()>& check)
    : m_check(check) {
    const auto isUnknown = [&](int x, int y) {
        return unknown[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                       static_cast<std::size_t>(x)] != 0;
    };
    std::vector<float> given;
    for (int y = 0; y < size.height; ++y) {
        check();
        for (int x = 0; x < size.width; ++x) {
            if (!isUnknown(x, y))
                continue;
            m_pixels.push_back({x, y});
            int known = 0;
            for (const Step& step : kSteps)
                if (inside(x + step.x, y + step.y, size) && !isUnknown(x + step.x, y + step.y))
                    ++known;
            given.push_back(static_cast<float>(known));
        }
    }
    m_grids.emplace(m_pixels, given, check);
    for (Vector* vector : {&m_f, &m_residual, &m_way, &m_image}) {
        check();
        vector->assign(count() + 1, 0.0);
    }
}

template <class Visit> void IterativeRegion::each(Visit visit) const {
    constexpr std::size_t kBetweenChecks = 1 << 16;
    for (std::size_t first = 0; first < count(); first += kBetweenChecks) {
        m_check();
        for (std::size_t i = first, end = std::min(count(), first + kBetweenChecks); i < end; ++i)
            visit(i);
    }
}

double IterativeRegion::product(const Vector& a, const Vector& b) const {
    double sum = 0;
    each([&](std::size_t i) { sum += a[i] * b[i]; });
    return sum;
}

double IterativeRegion::worst() const {
    double most = 0;
    each([&](std::size_t i) { most = std::max(most, std::abs(m_residual[i])); });
    return most;
}

double IterativeRegion::begin(std::span<const float> divergence, const PlaneView& values) {
    double largest = 0;
    each([&](std::size_t i) {
        m_f[i] = static_cast<double>(values(m_pixels[i].x, m_pixels[i].y));
        largest = std::max(largest, std::abs(m_f[i]));
    });
    const Size size{values.width, values.height};
    m_grids->multiply(m_f, m_image);
    each([&](std::size_t i) {
        const auto [x, y] = m_pixels[i];
        const Multigrid::Cell& cell = m_grids->cells()[i];
        double right = -static_cast<double>(divergence[i]);
        const int neighbours[] = {cell.left, cell.right, cell.up, cell.down};
        for (std::size_t k = 0; k < 4; ++k)
            if (const int u = x + kSteps[k].x, v = y + kSteps[k].y;
                neighbours[k] == m_grids->count() && inside(u, v, size)) {
                right += static_cast<double>(values(u, v));
                largest = std::max(largest, std::abs(static_cast<double>(values(u, v))));
            }
        m_residual[i] = right - m_image[i];
    });
    return largest;
}

void IterativeRegion::precondition() {
    each([&](std::size_t i) { m_grids->right()[i] = static_cast<float>(m_residual[i]); });
    const std::vector<float>& solution = m_grids->precondition();
    each([&](std::size_t i) { m_image[i] = static_cast<double>(solution[i]); });
}

void IterativeRegion::solve(std::span<const float> divergence, PlaneSpan values,
                            const std::function<void(double)>& progress) {
    constexpr int kMostSteps = 1000;
    constexpr double kPrecision = 1e-7;
    const double wanted = kPrecision * std::max(begin(divergence, values), 1e-30);
    const double first = worst();
    double now = first, energy = 0;
    for (int n = 0; n < kMostSteps && now > wanted; ++n) {
        precondition();
        const double next = product(m_residual, m_image);
        const double share = n == 0 ? 0 : next / energy;
        energy = next;
        each([&](std::size_t i) { m_way[i] = m_image[i] + share * m_way[i]; });
        m_grids->multiply(m_way, m_image);
        const double length = energy / product(m_way, m_image);
        each([&](std::size_t i) {
            m_f[i] += length * m_way[i];
            m_residual[i] -= length * m_image[i];
        });
        now = worst();
        progress(std::clamp(std::log(first / std::max(now, 1e-300)) / std::log(first / wanted), 0.0, 1.0));
    }
    each([&](std::size_t i) { values(m_pixels[i].x, m_pixels[i].y) = static_cast<float>(m_f[i]); });
}

} // namespace

void solvePoisson(const std::vector<std::uint8_t>& unknown, std::span<const float> divergence, Image& values,
                  const std::function<void(double)>& progress) {
    double done = 0;
    const std::function<void()> check = [&] { progress(done); };
    IterativeRegion region(unknown, values.size(), check);
    for (int c = 0; c < values.channels(); ++c)
        region.solve(divergence.subspan(static_cast<std::size_t>(c) * region.count(), region.count()),
                     values.plane(c), [&](double share) {
                         done = std::max(done, (c + share) / values.channels());
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
        // Transforms are in single precision; the remaining residual is solved for again.
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
