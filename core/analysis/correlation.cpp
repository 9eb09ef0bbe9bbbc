#include "core/analysis/correlation.h"

#include "core/math/fft.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

using Complex = RealFft2d::Complex;

/// Sums over rectangles of one channel, relative to its mean, and of its squares.
class IntegralImages {
public:
    IntegralImages(const PlaneView& plane, double mean)
        : m_stride(static_cast<std::size_t>(plane.width) + 1),
          m_sums(m_stride * (static_cast<std::size_t>(plane.height) + 1)) {
        for (int y = 0; y < plane.height; ++y) {
            Sums row;
            Sums* to = &m_sums[(static_cast<std::size_t>(y) + 1) * m_stride + 1];
            const Sums* above = to - m_stride;
            const float* from = plane.row(y);
            for (int x = 0; x < plane.width; ++x) {
                const double value = static_cast<double>(from[x]) - mean;
                row.value += value;
                row.square += value * value;
                to[x] = {above[x].value + row.value, above[x].square + row.square};
            }
        }
    }

    struct Sums {
        double value = 0, square = 0;
    };
    Sums over(int x, int y, int width, int height) const {
        const Sums* top = &m_sums[static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x)];
        const Sums* bottom = top + static_cast<std::size_t>(height) * m_stride;
        return {bottom[width].value - bottom[0].value - top[width].value + top[0].value,
                bottom[width].square - bottom[0].square - top[width].square + top[0].square};
    }

private:
    std::size_t m_stride;
    std::vector<Sums> m_sums;
};

/// Sum over the channels of f ⋆ g at every displacement, cyclic over the size of the transform.
class Products {
public:
    Products(const ImageView& f, const ImageView& g, const std::function<void()>& check)
        : m_fft({fastFftLength(f.width + g.width - 1), fastFftLength(f.height + g.height - 1)}),
          m_image(m_fft.imageSize()) {
        const std::vector<double> meansF = channelMeans(f), meansG = channelMeans(g);
        const bool same = f.data == g.data && f.size() == g.size();
        FftBuffer<Complex> sum(m_fft.spectrumSize()), first(m_fft.spectrumSize()),
            second(same ? 0 : m_fft.spectrumSize());
        std::fill_n(sum.data(), sum.size(), Complex(0, 0));
        for (int c = 0; c < f.channels; ++c) {
            transform(f.plane(c), meansF[static_cast<std::size_t>(c)], first, check);
            if (!same)
                transform(g.plane(c), meansG[static_cast<std::size_t>(c)], second, check);
            const Complex* other = same ? first.data() : second.data();
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum.data()[i] += first.data()[i] * std::conj(other[i]);
        }
        eachBlock(check, [&](int from, int to) { m_fft.backwardColumns(sum.data(), from, to); });
        m_fft.backwardRows(sum.data(), m_fft.size().height, m_image.data(), check);
    }

    /// The row of products for a vertical displacement; a horizontal one is at wrapped(dx).
    const float* row(int dy) const {
        return m_image.data() + (dy < 0 ? dy + m_fft.size().height : dy) * m_fft.rowStride();
    }
    int wrapped(int dx) const { return dx < 0 ? dx + m_fft.size().width : dx; }
    double scale() const { return 1.0 / static_cast<double>(m_fft.size().area()); }

private:
    template <class Body> void eachBlock(const std::function<void()>& check, const Body& body) const {
        for (int k = 0; k < m_fft.columns(); k += RealFft2d::kBlock) {
            check();
            body(k, std::min(m_fft.columns(), k + RealFft2d::kBlock));
        }
    }

    void transform(const PlaneView& plane, double mean, FftBuffer<Complex>& spectrum,
                   const std::function<void()>& check) {
        std::fill_n(m_image.data(), m_image.size(), 0.0F);
        for (int y = 0; y < plane.height; ++y)
            for (int x = 0; x < plane.width; ++x)
                m_image.data()[y * m_fft.rowStride() + x] =
                    static_cast<float>(static_cast<double>(plane(x, y)) - mean);
        m_fft.forwardRows(m_image.data(), plane.height, spectrum.data(), check);
        eachBlock(check, [&](int from, int to) { m_fft.forwardColumns(spectrum.data(), from, to); });
    }

    RealFft2d m_fft;
    FftBuffer<float> m_image;
};

/// γ for one row of displacements, as eq. 3.13.
class ImageRows {
public:
    ImageRows(const ImageView& f, const ImageView& g, const std::function<void()>& check)
        : m_f(f), m_g(g), m_products(f, g, check) {
        const std::vector<double> meansF = channelMeans(f), meansG = channelMeans(g);
        for (int c = 0; c < f.channels; ++c) {
            check();
            m_sumsF.emplace_back(f.plane(c), meansF[static_cast<std::size_t>(c)]);
            if (f.data != g.data)
                m_sumsG.emplace_back(g.plane(c), meansG[static_cast<std::size_t>(c)]);
            const double energy =
                m_sumsF.back().over(0, 0, f.width, f.height).square * static_cast<double>(f.size().area());
            m_energy += energy;
        }
    }

    float gamma(int dx, int dy) const {
        const int x0 = std::max(0, dx), y0 = std::max(0, dy);
        const int width = std::min(m_f.width, dx + m_g.width) - x0;
        const int height = std::min(m_f.height, dy + m_g.height) - y0;
        const double count = static_cast<double>(width) * height;
        double above =
            count * static_cast<double>(m_products.row(dy)[m_products.wrapped(dx)]) * m_products.scale();
        double below = 0;
        const std::vector<IntegralImages>& sumsG = m_sumsG.empty() ? m_sumsF : m_sumsG;
        for (std::size_t c = 0; c < m_sumsF.size(); ++c) {
            const auto a = m_sumsF[c].over(x0, y0, width, height);
            const auto b = sumsG[c].over(x0 - dx, y0 - dy, width, height);
            above -= a.value * b.value;
            below += std::sqrt(std::max(0.0, count * a.square - a.value * a.value) *
                               std::max(0.0, count * b.square - b.value * b.value));
        }
        // Below this the variance of the overlap is only rounding error of the sums.
        constexpr double kNothing = 1e-9;
        const double whole = static_cast<double>(m_f.width) * m_f.height;
        const double share = count / whole;
        if (below <= kNothing * m_energy * share * share)
            return 0;
        return static_cast<float>(std::clamp(above / below, -1.0, 1.0));
    }

private:
    ImageView m_f, m_g;
    Products m_products;
    std::vector<IntegralImages> m_sumsF, m_sumsG;
    double m_energy = 0; ///< N S_f² over all of f, summed over the channels
};

} // namespace

Correlation::Correlation(Size f, Size g)
    : m_f(f), m_g(g), m_stride(static_cast<std::size_t>(f.width) + static_cast<std::size_t>(g.width) - 1),
      m_values(m_stride * (static_cast<std::size_t>(f.height) + static_cast<std::size_t>(g.height) - 1)) {}

double Correlation::between(double dx, double dy) const {
    const int x = static_cast<int>(std::floor(dx)), y = static_cast<int>(std::floor(dy));
    const double u = dx - x, v = dy - y;
    const int nextX = std::min(x + 1, right()), nextY = std::min(y + 1, bottom());
    return (1 - v) * ((1 - u) * static_cast<double>(at(x, y)) + u * static_cast<double>(at(nextX, y))) +
           v * ((1 - u) * static_cast<double>(at(x, nextY)) + u * static_cast<double>(at(nextX, nextY)));
}

Size Correlation::overlap(int dx, int dy) const {
    return {std::min(m_f.width, dx + m_g.width) - std::max(0, dx),
            std::min(m_f.height, dy + m_g.height) - std::max(0, dy)};
}

Image Correlation::picture() const {
    Image image({left() + right() + 1, top() + bottom() + 1}, 1);
    for (int y = 0; y < image.height(); ++y)
        std::copy_n(m_values.data() + static_cast<std::size_t>(y) * m_stride, m_stride,
                    image.plane(0).row(y));
    return image;
}

Correlation correlate(const ImageView& f, const ImageView& g, const std::function<void()>& check) {
    Correlation result(f.size(), g.size());
    const ImageRows rows(f, g, check);
    for (int dy = -result.top(); dy <= result.bottom(); ++dy) {
        check();
        for (int dx = -result.left(); dx <= result.right(); ++dx)
            result.at(dx, dy) = rows.gamma(dx, dy);
    }
    return result;
}

Correlation autocorrelation(const ImageView& image, const std::function<void()>& check) {
    Correlation result(image.size(), image.size());
    const ImageRows rows(image, image, check);
    for (int dy = 0; dy <= result.bottom(); ++dy) {
        check();
        for (int dx = dy == 0 ? 0 : -result.left(); dx <= result.right(); ++dx)
            result.at(dx, dy) = result.at(-dx, -dy) = rows.gamma(dx, dy);
    }
    return result;
}

} // namespace texloom
