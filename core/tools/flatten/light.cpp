#include "core/tools/flatten/light.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom::flatten {

namespace {

/// Cells along the longer side of the grid on which light is fitted.
constexpr int kCells = 96;

/// Log brightness in square cells of an image, with how many pixels of each count.
struct Grid {
    int width, height;
    double cell; ///< side in pixels
    std::vector<double> values, weights;

    Grid(int columns, int rows, double side)
        : width(columns), height(rows), cell(side), values(count(), 0.0), weights(count(), 0.0) {}
    std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

int lightChannels(const Image& image) {
    return image.channels() >= 3 ? 3 : 1;
}

double brightness(const Image& image, int x, int y) {
    double sum = 0;
    const int channels = lightChannels(image);
    for (int c = 0; c < channels; ++c)
        sum += image(x, y, c);
    return sum / channels;
}

/// Below this share of the mean everything counts as equally dark: a logarithm of noise tells nothing.
double floorOf(const Image& image) {
    constexpr double kDarkest = 0.01;
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum += std::max(0.0, brightness(image, x, y));
    return kDarkest * sum / static_cast<double>(image.size().area());
}

Grid gridOf(const Image& image, const Image* mask, double darkest, const std::function<void()>& check) {
    const double side = std::max(1.0, static_cast<double>(image.size().longerSide()) / kCells);
    Grid grid(static_cast<int>(std::ceil(image.width() / side)),
              static_cast<int>(std::ceil(image.height() / side)), side);
    for (int y = 0; y < image.height(); ++y) {
        check();
        for (int x = 0; x < image.width(); ++x) {
            if (mask != nullptr && (*mask)(x, y, 0) == 0)
                continue;
            const std::size_t at = grid.index(static_cast<int>(x / side), static_cast<int>(y / side));
            grid.values[at] += std::log(std::max(darkest, brightness(image, x, y)));
            grid.weights[at] += 1;
        }
    }
    return grid; // sums, until fitted
}

/// One pass of a Gaussian of `sigma` cells along an axis over sums and weights alike.
void blur(std::vector<double>& values, int width, int height, double sigma, bool across) {
    const int radius = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
    std::vector<double> kernel(static_cast<std::size_t>(radius) + 1);
    for (int i = 0; i <= radius; ++i)
        kernel[static_cast<std::size_t>(i)] = std::exp(-0.5 * i * i / (sigma * sigma));
    const std::vector<double> before = values;
    const int length = across ? width : height;
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int here = across ? x : y;
            double sum = 0;
            for (int k = std::max(0, here - radius); k <= std::min(length - 1, here + radius); ++k)
                sum += kernel[static_cast<std::size_t>(std::abs(k - here))] *
                       before[across ? at(k, y) : at(x, k)];
            values[at(x, y)] = sum;
        }
}

/// The powers u^i v^j with i + j up to `order`, at a cell; u and v go from -1 to 1.
Eigen::VectorXd powersAt(const Grid& grid, int x, int y, int order) {
    const double u = 2 * (x + 0.5) / grid.width - 1, v = 2 * (y + 0.5) / grid.height - 1;
    Eigen::VectorXd powers((order + 1) * (order + 2) / 2);
    int k = 0;
    for (int i = 0; i <= order; ++i)
        for (int j = 0; i + j <= order; ++j)
            powers[k++] = std::pow(u, i) * std::pow(v, j);
    return powers;
}

void fitPolynomial(Grid& grid, int order) {
    const Eigen::Index count = (order + 1) * (order + 2) / 2;
    Eigen::MatrixXd normal = 1e-9 * Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const std::size_t at = grid.index(x, y);
            const Eigen::VectorXd powers = powersAt(grid, x, y, order);
            normal += grid.weights[at] * powers * powers.transpose();
            right += grid.values[at] * powers;
        }
    const Eigen::VectorXd fit = normal.ldlt().solve(right);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            grid.values[grid.index(x, y)] = fit.dot(powersAt(grid, x, y, order));
}

/// The plane that fits best, and what a normalised convolution makes of the rest: a window alone would bend
/// a slope down at the edges. Cells without pixels take what their surroundings say.
void fitSmooth(Grid& grid, double sigma) {
    Grid plane = grid;
    fitPolynomial(plane, 1);
    for (std::size_t i = 0; i < grid.count(); ++i)
        grid.values[i] -= grid.weights[i] * plane.values[i];
    for (const bool across : {true, false}) {
        blur(grid.values, grid.width, grid.height, sigma, across);
        blur(grid.weights, grid.width, grid.height, sigma, across);
    }
    constexpr double kNothing = 1e-12;
    for (std::size_t i = 0; i < grid.count(); ++i)
        grid.values[i] =
            plane.values[i] + (grid.weights[i] > kNothing ? grid.values[i] / grid.weights[i] : 0);
}

/// The fit at a pixel, linear between the cells' middles and beyond them.
double fitAt(const Grid& grid, int x, int y) {
    const double column = (x + 0.5) / grid.cell - 0.5, row = (y + 0.5) / grid.cell - 0.5;
    const int left = std::clamp(static_cast<int>(std::floor(column)), 0, std::max(0, grid.width - 2));
    const int top = std::clamp(static_cast<int>(std::floor(row)), 0, std::max(0, grid.height - 2));
    const int right = std::min(left + 1, grid.width - 1), bottom = std::min(top + 1, grid.height - 1);
    const double u = std::clamp(column - left, -0.5, 1.5), v = std::clamp(row - top, -0.5, 1.5);
    const auto value = [&](int i, int j) { return grid.values[grid.index(i, j)]; };
    return (1 - v) * ((1 - u) * value(left, top) + u * value(right, top)) +
           v * ((1 - u) * value(left, bottom) + u * value(right, bottom));
}

void scale(Image& image, int x, int y, double factor) {
    for (int c = 0; c < lightChannels(image); ++c)
        image(x, y, c) = static_cast<float>(image(x, y, c) * factor);
}

} // namespace

void evenOut(Image& image, const Settings& settings, const Image* mask, const std::function<void()>& check) {
    const double darkest = floorOf(image);
    if (darkest <= 0 || settings.strength == 0)
        return;
    Grid grid = gridOf(image, mask, darkest, check);
    if (settings.model == Model::Smooth)
        fitSmooth(grid, std::max(0.5, settings.width * image.size().shorterSide() / grid.cell));
    else
        fitPolynomial(grid, settings.order);
    double before = 0, after = 0;
    for (int y = 0; y < image.height(); ++y) {
        check();
        for (int x = 0; x < image.width(); ++x) {
            before += brightness(image, x, y);
            scale(image, x, y, std::exp(-settings.strength * (fitAt(grid, x, y) - std::log(100 * darkest))));
            after += brightness(image, x, y);
        }
    }
    for (int y = 0; after > 0 && before > 0 && y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            scale(image, x, y, before / after);
}

} // namespace texloom::flatten
