#include "core/math/waves.h"

#include "core/math/fft.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

using WaveComplex = std::complex<double>;

constexpr double kTurn = 2 * std::numbers::pi;
/// Times the image's side is the spectrum's.
constexpr int kPadding = 4;

/// e^(2πi b x) for x = 0 … length − 1.
std::vector<WaveComplex> powers(double b, int length, double first = 0) {
    std::vector<WaveComplex> values;
    for (int x = 0; x < length; ++x)
        values.push_back(std::polar(1.0, kTurn * b * (x + first)));
    return values;
}

/// Half a period of a squared sine, which keeps peaks apart.
std::vector<float> hann(int length) {
    std::vector<float> weights;
    for (int x = 0; x < length; ++x) {
        const double sine = std::sin(std::numbers::pi * (x + 0.5) / length);
        weights.push_back(static_cast<float>(sine * sine));
    }
    return weights;
}

/// A frequency at which the spectrum has a peak.
struct Peak {
    double x, y, power;
};

/// Fits waves to an image.
class Fit {
public:
    Fit(const ImageView& image, const PlaneView& mask, const WaveOptions& options,
        const std::function<void()>& check)
        : m_mask(mask), m_options(options), m_check(check), m_size(image.size()), m_left(image) {
        m_model.means.assign(static_cast<std::size_t>(image.channels), 0.0);
        each([&](int x, int y) {
            m_pixels += 1;
            for (int c = 0; c < image.channels; ++c)
                m_model.means[static_cast<std::size_t>(c)] += static_cast<double>(image(x, y, c));
        });
        for (int c = 0; c < image.channels; ++c) {
            double& mean = m_model.means[static_cast<std::size_t>(c)];
            mean = m_pixels > 0 ? mean / m_pixels : 0;
            for (int y = 0; y < m_size.height; ++y)
                for (int x = 0; x < m_size.width; ++x)
                    m_left(x, y, c) -= static_cast<float>(mean);
        }
        m_variance = leftOver();
    }

    WaveModel run() {
        constexpr int kRounds = 3;
        const bool flat = !(m_variance > 1e-12 * m_pixels);
        for (int round = 0; round < kRounds && !flat && addPeaks(); ++round)
            refine();
        m_model.share = m_variance > 0 ? 1 - leftOver() / m_variance : 0;
        const auto strength = [](const Wave& wave) {
            double sum = 0;
            for (const WaveComplex& one : wave.strengths)
                sum += std::norm(one);
            return sum;
        };
        std::stable_sort(m_model.waves.begin(), m_model.waves.end(),
                         [&](const Wave& a, const Wave& b) { return strength(a) > strength(b); });
        return std::move(m_model);
    }

private:
    /// Calls visit(x, y) for every pixel that counts.
    template <class Visit> void each(const Visit& visit) const {
        for (int y = 0; y < m_size.height; ++y) {
            m_check();
            for (int x = 0; x < m_size.width; ++x)
                if (!m_mask.data || m_mask(x, y) != 0)
                    visit(x, y);
        }
    }

    double leftOver() const {
        double sum = 0;
        each([&](int x, int y) {
            for (int c = 0; c < m_left.channels(); ++c)
                sum += static_cast<double>(m_left(x, y, c)) * static_cast<double>(m_left(x, y, c));
        });
        return sum;
    }

    /// The squared moduli of the spectrum of what is left, over all channels, column by column.
    std::vector<double> power(const RealFft2d& fft) const {
        const std::vector<float> alongX = hann(m_size.width), alongY = hann(m_size.height);
        std::vector<double> sums(fft.spectrumSize(), 0.0);
        FftBuffer<float> plane(fft.imageSize());
        FftBuffer<std::complex<float>> spectrum(fft.spectrumSize());
        for (int c = 0; c < m_left.channels(); ++c) {
            std::fill_n(plane.data(), fft.imageSize(), 0.0F);
            each([&](int x, int y) {
                plane.data()[y * fft.rowStride() + x] = m_left(x, y, c) *
                                                        alongX[static_cast<std::size_t>(x)] *
                                                        alongY[static_cast<std::size_t>(y)];
            });
            fft.forward(plane.data(), spectrum.data(), m_check);
            for (int k = 0; k < fft.columns(); ++k)
                for (int l = 0; l < fft.size().height; ++l) {
                    const auto i = static_cast<std::size_t>(k * fft.columnStride() + l);
                    sums[i] += static_cast<double>(std::norm(spectrum.data()[i]));
                }
        }
        return sums;
    }

    /// How far two frequencies lie apart, in cycles per side.
    double apart(const Peak& peak, double x, double y) const {
        return std::hypot((peak.x - x) * m_size.width, (peak.y - y) * m_size.height);
    }

    /// All local maxima in one half plane, the highest first.
    std::vector<Peak> peaks() const {
        const RealFft2d fft(
            {fastFftLength(kPadding * m_size.width), fastFftLength(kPadding * m_size.height)});
        const std::vector<double> sums = power(fft);
        const int width = fft.size().width, height = fft.size().height;
        const auto at = [&](int k, int l) {
            // The other half plane mirrors this one.
            if (k < 0 || k >= fft.columns()) {
                k = k < 0 ? -k : width - k;
                l = -l;
            }
            return sums[static_cast<std::size_t>(k * fft.columnStride() + (l + 2 * height) % height)];
        };
        std::vector<Peak> found;
        for (int k = 0; k < fft.columns(); ++k) {
            m_check();
            for (int l = 0; l < height; ++l) {
                const double own = at(k, l);
                bool highest = own > 0 && (k > 0 || l <= height / 2);
                for (int d = 0; d < 9 && highest; ++d)
                    highest = d == 4 || own >= at(k + d % 3 - 1, l + d / 3 - 1);
                const Peak peak{static_cast<double>(k) / width,
                                static_cast<double>(l <= height / 2 ? l : l - height) / height, own};
                if (highest && apart(peak, 0, 0) >= 1)
                    found.push_back(peak);
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Peak& a, const Peak& b) { return a.power > b.power; });
        return found;
    }

    /// Takes up the peaks of what is left. @return whether there was one.
    bool addPeaks() {
        bool added = false;
        for (const Peak& peak : peaks()) {
            if (m_highest == 0)
                m_highest = peak.power;
            if (static_cast<int>(m_model.waves.size()) >= m_options.most ||
                peak.power < m_options.threshold * m_options.threshold * m_highest)
                break;
            // Nearer than the window tells apart, a peak is a shoulder of another.
            const bool known = std::any_of(m_model.waves.begin(), m_model.waves.end(), [&](const Wave& wave) {
                return std::min(apart(peak, wave.x, wave.y), apart(peak, -wave.x, -wave.y)) < 2;
            });
            if (known)
                continue;
            m_model.waves.push_back(
                {peak.x, peak.y, std::vector<WaveComplex>(m_model.means.size(), WaveComplex(0, 0)), 0});
            added = true;
        }
        m_spreads.resize(m_model.waves.size(), 0.0);
        if (added)
            solveStrengths();
        return added;
    }

    void refine() {
        constexpr int kMostSweeps = 12;
        constexpr double kSettled = 1e-4;
        for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
            centre();
            double moved = 0;
            for (Wave& wave : m_model.waves)
                moved = std::max(moved, step(wave));
            if (moved < kSettled)
                break;
        }
        solveStrengths();
        centre();
        const double unknowns = 2 + 2 * m_left.channels();
        const double deviation =
            std::sqrt(leftOver() / std::max(1.0, m_pixels * m_left.channels() - unknowns));
        for (std::size_t i = 0; i < m_model.waves.size(); ++i)
            m_model.waves[i].uncertainty = deviation * m_spreads[i];
    }

    /// Waves that do not end with the picture have a mean of their own, which is not the texture's.
    void centre() {
        std::vector<double> sums(m_model.means.size(), 0.0);
        each([&](int x, int y) {
            for (int c = 0; c < m_left.channels(); ++c)
                sums[static_cast<std::size_t>(c)] += static_cast<double>(m_left(x, y, c));
        });
        for (int c = 0; c < m_left.channels(); ++c) {
            const double mean = sums[static_cast<std::size_t>(c)] / m_pixels;
            m_model.means[static_cast<std::size_t>(c)] += mean;
            for (int y = 0; y < m_size.height; ++y)
                for (int x = 0; x < m_size.width; ++x)
                    m_left(x, y, c) -= static_cast<float>(mean);
        }
    }

    /// Adds a wave to what is left, or takes it off.
    void add(const Wave& wave, double sign) {
        const std::vector<WaveComplex> alongX = powers(wave.x, m_size.width),
                                       alongY = powers(wave.y, m_size.height);
        for (int y = 0; y < m_size.height; ++y)
            for (int c = 0; c < m_left.channels(); ++c) {
                const WaveComplex row =
                    wave.strengths[static_cast<std::size_t>(c)] * alongY[static_cast<std::size_t>(y)];
                float* to = m_left.plane(c).row(y);
                for (int x = 0; x < m_size.width; ++x) {
                    const WaveComplex& e = alongX[static_cast<std::size_t>(x)];
                    to[x] += static_cast<float>(sign * (row.real() * e.real() - row.imag() * e.imag()));
                }
            }
    }

    /// The normal equations of a wave's frequency and its strength in one channel.
    struct Normal {
        double matrix[4][4] = {}, right[4] = {};
        void add(const double (&terms)[4], double value) {
            for (int i = 0; i < 4; ++i) {
                right[i] += terms[i] * value;
                for (int j = 0; j <= i; ++j)
                    matrix[i][j] += terms[i] * terms[j];
            }
        }
    };

    /// One Gauss–Newton step for a wave's frequency and strengths, the other waves as they are.
    /// @return how far the frequency moved, in cycles per side.
    double step(Wave& wave) {
        add(wave, 1);
        const int channels = m_left.channels();
        std::vector<Normal> normals(static_cast<std::size_t>(channels));
        const double middleX = 0.5 * (m_size.width - 1), middleY = 0.5 * (m_size.height - 1);
        // Counted from the middle, frequency and phase do not disturb each other.
        const std::vector<WaveComplex> alongX = powers(wave.x, m_size.width, -middleX),
                                       alongY = powers(wave.y, m_size.height, -middleY);
        const WaveComplex shift = std::polar(1.0, kTurn * (wave.x * middleX + wave.y * middleY));
        each([&](int x, int y) {
            const WaveComplex &a = alongX[static_cast<std::size_t>(x)],
                              &b = alongY[static_cast<std::size_t>(y)];
            const double real = a.real() * b.real() - a.imag() * b.imag();
            const double imaginary = a.real() * b.imag() + a.imag() * b.real();
            for (int c = 0; c < channels; ++c) {
                const WaveComplex own = wave.strengths[static_cast<std::size_t>(c)] * shift;
                const double slope = -kTurn * (own.real() * imaginary + own.imag() * real);
                normals[static_cast<std::size_t>(c)].add(
                    {slope * (x - middleX), slope * (y - middleY), real, -imaginary},
                    static_cast<double>(m_left(x, y, c)));
            }
        });
        const double moved = solve(normals, wave);
        const WaveComplex back = std::polar(1.0, -kTurn * (wave.x * middleX + wave.y * middleY));
        if (moved >= 0)
            for (WaveComplex& strength : wave.strengths)
                strength *= back;
        add(wave, -1);
        return std::max(0.0, moved);
    }

    /// Moves a wave as its normal equations say, strengths as counted from the middle.
    /// @return how far, in cycles per side, or −1 where they say nothing.
    double solve(const std::vector<Normal>& normals, Wave& wave) {
        const auto unknowns = static_cast<Eigen::Index>(2 + 2 * normals.size());
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns, unknowns);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
        for (std::size_t c = 0; c < normals.size(); ++c) {
            const auto own = static_cast<Eigen::Index>(2 + 2 * c);
            const Eigen::Index index[4] = {0, 1, own, own + 1};
            for (int i = 0; i < 4; ++i) {
                right[index[i]] += normals[c].right[i];
                for (int j = 0; j <= i; ++j)
                    matrix(index[i], index[j]) += normals[c].matrix[i][j];
            }
        }
        const Eigen::MatrixXd whole = matrix.selfadjointView<Eigen::Lower>();
        const Eigen::VectorXd solution = whole.ldlt().solve(right);
        const double farthest =
            std::max(std::abs(solution[0]) * m_size.width, std::abs(solution[1]) * m_size.height);
        if (!std::isfinite(farthest) || !solution.allFinite())
            return -1;
        constexpr double kLongest = 0.25;
        const double share = farthest > kLongest ? kLongest / farthest : 1;
        wave.x += share * solution[0];
        wave.y += share * solution[1];
        for (std::size_t c = 0; c < normals.size(); ++c)
            wave.strengths[c] = {solution[static_cast<Eigen::Index>(2 + 2 * c)],
                                 solution[static_cast<Eigen::Index>(3 + 2 * c)]};
        const Eigen::Matrix2d inverse = whole.topLeftCorner<2, 2>().inverse();
        const double variance = std::max(inverse(0, 0), inverse(1, 1));
        m_spreads[static_cast<std::size_t>(&wave - m_model.waves.data())] =
            variance > 0 && std::isfinite(variance) ? std::sqrt(variance) : 0;
        return share * farthest;
    }

    /// All strengths at once, since waves overlap in a picture of a few cycles.
    void solveStrengths() {
        for (const Wave& wave : m_model.waves)
            add(wave, 1);
        const auto count = static_cast<Eigen::Index>(2 * m_model.waves.size());
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, m_left.channels());
        std::vector<std::vector<WaveComplex>> alongX, alongY;
        for (const Wave& wave : m_model.waves) {
            alongX.push_back(powers(wave.x, m_size.width));
            alongY.push_back(powers(wave.y, m_size.height));
        }
        for (int y = 0; y < m_size.height; ++y) {
            m_check();
            Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(m_size.width, count);
            Eigen::MatrixXd values = Eigen::MatrixXd::Zero(m_size.width, m_left.channels());
            for (int x = 0; x < m_size.width; ++x) {
                if (m_mask.data && m_mask(x, y) == 0)
                    continue;
                for (std::size_t i = 0; i < m_model.waves.size(); ++i) {
                    const WaveComplex e =
                        alongX[i][static_cast<std::size_t>(x)] * alongY[i][static_cast<std::size_t>(y)];
                    terms(x, static_cast<Eigen::Index>(2 * i)) = e.real();
                    terms(x, static_cast<Eigen::Index>(2 * i + 1)) = -e.imag();
                }
                for (int c = 0; c < m_left.channels(); ++c)
                    values(x, c) = static_cast<double>(m_left(x, y, c));
            }
            normal.noalias() += terms.transpose() * terms;
            right.noalias() += terms.transpose() * values;
        }
        // A wave at the highest frequency has no phase of its own.
        normal.diagonal().array() += 1e-9 * m_pixels;
        const Eigen::MatrixXd solution = normal.ldlt().solve(right);
        for (std::size_t i = 0; i < m_model.waves.size(); ++i) {
            for (int c = 0; c < m_left.channels(); ++c)
                m_model.waves[i].strengths[static_cast<std::size_t>(c)] = {
                    solution(static_cast<Eigen::Index>(2 * i), c),
                    solution(static_cast<Eigen::Index>(2 * i + 1), c)};
            add(m_model.waves[i], -1);
        }
    }

    PlaneView m_mask;
    const WaveOptions& m_options;
    const std::function<void()>& m_check;
    Size m_size;
    Image m_left; ///< the image less its mean and the waves
    WaveModel m_model;
    std::vector<double> m_spreads; ///< of each wave's frequency, over the deviation of what is left
    double m_pixels = 0, m_variance = 0, m_highest = 0;
};

} // namespace

WaveModel findWaves(const ImageView& image, const PlaneView& mask, const WaveOptions& options,
                    const std::function<void()>& check) {
    return Fit(image, mask, options, check).run();
}

WaveModel closed(const WaveModel& model, Size size, Wrap wrap, double& largestMove) {
    WaveModel moved = model;
    largestMove = 0;
    for (Wave& wave : moved.waves) {
        const auto close = [&](double& b, int length) {
            const double whole = std::round(b * length);
            largestMove = std::max(largestMove, std::abs(whole - b * length));
            b = whole / length;
        };
        if (wrap.x)
            close(wave.x, size.width);
        if (wrap.y)
            close(wave.y, size.height);
    }
    return moved;
}

Image drawn(const WaveModel& model, const Region& region, JobContext& context) {
    const auto channels = static_cast<int>(model.means.size());
    Image image(region.size, channels);
    std::vector<std::vector<WaveComplex>> alongX;
    for (const Wave& wave : model.waves)
        alongX.push_back(powers(wave.x, region.size.width, region.x));
    context.parallel(0, region.size.height, [&](int y) {
        for (int c = 0; c < channels; ++c) {
            std::vector<double> row(static_cast<std::size_t>(region.size.width),
                                    model.means[static_cast<std::size_t>(c)]);
            for (std::size_t i = 0; i < model.waves.size(); ++i) {
                const Wave& wave = model.waves[i];
                const WaveComplex f = wave.strengths[static_cast<std::size_t>(c)] *
                                      std::polar(1.0, kTurn * wave.y * (region.y + y));
                for (std::size_t x = 0; x < row.size(); ++x)
                    row[x] += f.real() * alongX[i][x].real() - f.imag() * alongX[i][x].imag();
            }
            std::transform(row.begin(), row.end(), image.plane(c).row(y),
                           [](double value) { return static_cast<float>(value); });
        }
    });
    return image;
}

std::uint64_t findWavesBytes(Size size, int channels, const WaveOptions& options) {
    const RealFft2d fft({fastFftLength(kPadding * size.width), fastFftLength(kPadding * size.height)});
    const auto waves = static_cast<std::uint64_t>(options.most);
    return Image::bytesFor(size, channels) + fft.imageSize() * sizeof(float) +
           fft.spectrumSize() * (sizeof(std::complex<float>) + sizeof(double)) +
           fft.spectrumSize() / 4 * sizeof(Peak) + 64 * waves * waves +
           waves * static_cast<std::uint64_t>(size.width + size.height) * 64;
}

} // namespace texloom
