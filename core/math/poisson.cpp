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

std::uint64_t regionPoissonBytes(std::uint64_t unknown, int channels) {
    constexpr std::uint64_t kEquation = 130;
    return unknown * (kEquation + 2 * static_cast<std::uint64_t>(channels) * sizeof(float));
}

namespace {

/// Solves Poisson's equation on all of a picture by Fourier transforms: of the picture as it is where it
/// wraps, else of the picture mirrored to twice its size, which makes cosine transforms of them.
class WholeSolver {
public:
    WholeSolver(Size size, PoissonBorder border, const std::function<void()>& check)
        : m_size(size), m_wraps(border == PoissonBorder::Wraps), m_check(check),
          m_fft(m_wraps ? size : Size{2 * size.width, 2 * size.height}), m_image(m_fft.imageSize()),
          m_spectrum(m_fft.spectrumSize()), m_residual(static_cast<std::size_t>(size.area())) {}

    /// @param progress called with the share done. @return f with a mean of 0, by rows.
    std::vector<double> solved(const PlaneView& divergence, const std::function<void(double)>& progress) {
        // Transforms are in single precision; what remains is solved for again.
        constexpr int kRounds = 4;
        constexpr double kPrecision = 2e-7;
        std::vector<double> f(m_residual.size(), 0.0);
        double wanted = 0;
        for (int round = 0; round < kRounds; ++round) {
            const double most = subtract(divergence, f);
            if (round == 0)
                wanted = kPrecision * most;
            else if (most <= wanted)
                break;
            correct(f);
            progress((round + 1.0) / kRounds);
        }
        subtractMean(f);
        return f;
    }

private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
               static_cast<std::size_t>(x);
    }

    /// The residual of f, without its mean, which no f can have. @return its largest value
    double subtract(const PlaneView& divergence, const std::vector<double>& f) {
        const int width = m_size.width, height = m_size.height;
        // A neighbour beyond a border without flux is the pixel itself.
        const auto beside = [this](int at, int length) {
            return m_wraps ? (at + length) % length : std::clamp(at, 0, length - 1);
        };
        for (int y = 0; y < height; ++y) {
            m_check();
            const double* const here = f.data() + at(0, y);
            const double* const above = f.data() + at(0, beside(y - 1, height));
            const double* const below = f.data() + at(0, beside(y + 1, height));
            for (int x = 0; x < width; ++x)
                m_residual[at(x, y)] = static_cast<double>(divergence(x, y)) -
                                       (here[beside(x - 1, width)] + here[beside(x + 1, width)] + above[x] +
                                        below[x] - 4 * here[x]);
        }
        subtractMean(m_residual);
        double most = 0;
        for (const double value : m_residual)
            most = std::max(most, std::abs(value));
        return most;
    }

    static void subtractMean(std::vector<double>& values) {
        double sum = 0;
        for (const double value : values)
            sum += value;
        const double mean = sum / static_cast<double>(values.size());
        for (double& value : values)
            value -= mean;
    }

    /// Adds the solution for the residual to f.
    void correct(std::vector<double>& f) {
        const Size size = m_fft.size();
        for (int y = 0; y < size.height; ++y) {
            m_check();
            const double* const row = m_residual.data() + at(0, std::min(y, 2 * m_size.height - 1 - y));
            float* const to = m_image.data() + y * m_fft.rowStride();
            for (int x = 0; x < size.width; ++x)
                to[x] = static_cast<float>(row[std::min(x, 2 * m_size.width - 1 - x)]);
        }
        m_fft.forward(m_image.data(), m_spectrum.data(), m_check);
        divide();
        m_fft.backward(m_spectrum.data(), m_image.data(), m_check);
        const double scale = 1 / static_cast<double>(size.area());
        for (int y = 0; y < m_size.height; ++y) {
            m_check();
            const float* const from = m_image.data() + y * m_fft.rowStride();
            for (int x = 0; x < m_size.width; ++x)
                f[at(x, y)] += scale * static_cast<double>(from[x]);
        }
    }

    void divide() {
        const auto cosine = [](int k, int length) { return 2 * std::cos(2 * std::numbers::pi * k / length); };
        std::vector<double> down;
        for (int l = 0; l < m_fft.size().height; ++l)
            down.push_back(cosine(l, m_fft.size().height));
        for (int k = 0; k < m_fft.columns(); ++k) {
            m_check();
            const double across = cosine(k, m_fft.size().width);
            std::complex<float>* const column = m_spectrum.data() + k * m_fft.columnStride();
            for (std::size_t l = 0; l < down.size(); ++l)
                column[l] = k == 0 && l == 0 ? 0.0F : column[l] / static_cast<float>(across + down[l] - 4);
        }
    }

    Size m_size;
    bool m_wraps;
    const std::function<void()>& m_check;
    RealFft2d m_fft;
    FftBuffer<float> m_image;
    FftBuffer<std::complex<float>> m_spectrum;
    std::vector<double> m_residual;
};

} // namespace

Image solvePoisson(const ImageView& divergence, const std::vector<double>& means, PoissonBorder border,
                   const std::function<void(double)>& progress) {
    double done = 0;
    const std::function<void()> check = [&] { progress(done); };
    Image result(divergence.size(), divergence.channels);
    WholeSolver solver(divergence.size(), border, check);
    for (int c = 0; c < divergence.channels; ++c) {
        const std::vector<double> f = solver.solved(divergence.plane(c), [&](double share) {
            done = (c + share) / divergence.channels;
            check();
        });
        auto value = f.begin();
        for (int y = 0; y < result.height(); ++y)
            for (int x = 0; x < result.width(); ++x)
                result(x, y, c) = static_cast<float>(*value++ + means[static_cast<std::size_t>(c)]);
    }
    return result;
}

std::uint64_t wholePoissonBytes(Size size, PoissonBorder border) {
    const auto area = static_cast<std::uint64_t>(size.area());
    const std::uint64_t transformed = border == PoissonBorder::Wraps ? area : 4 * area;
    return 2 * area * sizeof(double) + 2 * transformed * sizeof(float) +
           (static_cast<std::uint64_t>(size.width + size.height) + 16) * 512;
}

} // namespace texloom
