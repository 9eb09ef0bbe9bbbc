#include "core/methods/regular_tile/tile_family.h"

#include "core/image/mirror.h"
#include "core/math/pca.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::regular_tile {

namespace {

/// Components with less of the variance than this are rounding.
constexpr double kLeastVariance = 1e-9;

/// Weights of the four samples round a point, `t` from the second, by Catmull and Rom's cubic.
std::array<float, 4> cubicWeights(double t) {
    return {static_cast<float>(0.5 * t * (-1 + t * (2 - t))),
            static_cast<float>(0.5 * (2 + t * t * (-5 + 3 * t))),
            static_cast<float>(0.5 * t * (1 + t * (4 - 3 * t))), static_cast<float>(0.5 * t * t * (t - 1))};
}

std::array<Vec2, 4> cornersOf(const Lattice& shape) {
    return {Vec2{0, 0}, shape.v1, shape.v2, shape.v1 + shape.v2};
}

} // namespace

TileFamily::TileFamily(const ImageView& exemplar, const PlaneView& mask, const Lattice& from,
                       const Lattice& shape, const Tile& corner, int margin, int bases, JobContext& context)
    : m_channels(exemplar.channels) {
    numberPixels(shape, margin);
    const Corners corners = wholeTiles(exemplar, mask, from, shape,
                                       {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    m_tiles = static_cast<int>(corners.size());
    std::vector<std::vector<float>> tiles(corners.size());
    context.parallel(0, m_tiles, [&](int i) {
        tiles[static_cast<std::size_t>(i)] = sampled(exemplar, corners[static_cast<std::size_t>(i)]);
    });
    analyse(std::move(tiles), std::min(bases, m_tiles - 1), context);
}

void TileFamily::numberPixels(const Lattice& shape, int margin) {
    // Copies lie at rounded places, a pixel off at most.
    const auto beside = [&](double side) {
        const double pixel = side / shape.area();
        return std::min(0.5, margin * pixel) + pixel;
    };
    const double beside1 = beside(shape.v2.length()), beside2 = beside(shape.v1.length());
    Vec2 least, most;
    for (const double a : {-beside1, 1 + beside1})
        for (const double b : {-beside2, 1 + beside2}) {
            const Vec2 at = shape.at(a, b);
            least = {std::min(least.x, at.x), std::min(least.y, at.y)};
            most = {std::max(most.x, at.x), std::max(most.y, at.y)};
        }
    const int left = static_cast<int>(std::floor(least.x)) - 1,
              top = static_cast<int>(std::floor(least.y)) - 1;
    m_box = {left,
             top,
             {static_cast<int>(std::ceil(most.x)) + 1 - left, static_cast<int>(std::ceil(most.y)) + 1 - top}};
    for (int y = m_box.y; y < m_box.bottom(); ++y)
        for (int x = m_box.x; x < m_box.right(); ++x) {
            const Vec2 c = shape.coordinates({x + 0.5, y + 0.5});
            const bool in = c.x >= -beside1 && c.x <= 1 + beside1 && c.y >= -beside2 && c.y <= 1 + beside2;
            m_number.push_back(in ? m_pixels++ : -1);
        }
}

TileFamily::Corners TileFamily::wholeTiles(const ImageView& exemplar, const PlaneView& mask,
                                           const Lattice& from, const Lattice& shape, Vec2 corner) const {
    const auto whole = [&](Vec2 place) {
        for (const Vec2& of : cornersOf(shape)) {
            const Vec2 at = place + of;
            constexpr double kRounding = 0.5;
            if (at.x < -kRounding || at.y < -kRounding || at.x > exemplar.width + kRounding ||
                at.y > exemplar.height + kRounding)
                return false;
        }
        if (mask.data == nullptr)
            return true;
        const int left = static_cast<int>(std::lround(place.x)), top = static_cast<int>(std::lround(place.y));
        for (int y = m_box.y; y < m_box.bottom(); ++y)
            for (int x = m_box.x; x < m_box.right(); ++x)
                if (at(x, y) >= 0 &&
                    mask(mirrored(left + x, mask.width), mirrored(top + y, mask.height)) == 0)
                    return false;
        return true;
    };
    double a0 = 0, a1 = 0, b0 = 0, b1 = 0;
    const double w = exemplar.width, h = exemplar.height;
    for (const Vec2 at : {Vec2{0, 0}, Vec2{w, 0}, Vec2{0, h}, Vec2{w, h}}) {
        const Vec2 c = from.coordinates(at - corner);
        a0 = std::min(a0, c.x);
        a1 = std::max(a1, c.x);
        b0 = std::min(b0, c.y);
        b1 = std::max(b1, c.y);
    }
    Corners all = {corner}; // the tile that was chosen counts in any case
    for (double b = std::floor(b0); b <= b1; ++b)
        for (double a = std::floor(a0); a <= a1; ++a)
            if ((a != 0 || b != 0) && whole(corner + from.at(a, b)))
                all.push_back(corner + from.at(a, b));
    const std::size_t step = (all.size() + kMostTiles - 1) / kMostTiles;
    Corners some;
    for (std::size_t i = 0; i < all.size(); i += step)
        some.push_back(all[i]);
    return some;
}

std::vector<float> TileFamily::sampled(const ImageView& exemplar, Vec2 corner) const {
    std::vector<float> values(static_cast<std::size_t>(m_pixels) * static_cast<std::size_t>(m_channels));
    const int left = static_cast<int>(std::floor(corner.x)), top = static_cast<int>(std::floor(corner.y));
    const std::array<float, 4> across = cubicWeights(corner.x - left), down = cubicWeights(corner.y - top);
    float* to = values.data();
    for (int y = m_box.y; y < m_box.bottom(); ++y)
        for (int x = m_box.x; x < m_box.right(); ++x) {
            if (at(x, y) < 0)
                continue;
            for (int c = 0; c < m_channels; ++c) {
                float sum = 0;
                for (int j = 0; j < 4; ++j)
                    for (int i = 0; i < 4; ++i)
                        sum += down[static_cast<std::size_t>(j)] * across[static_cast<std::size_t>(i)] *
                               exemplar(mirrored(left + x + i - 1, exemplar.width),
                                        mirrored(top + y + j - 1, exemplar.height), c);
                *to++ = sum;
            }
        }
    return values;
}

/// By the tiles' inner products, of which there are fewer than of their pixels'.
void TileFamily::analyse(std::vector<std::vector<float>> tiles, int bases, JobContext& context) {
    const std::size_t values = tiles.front().size();
    m_mean.assign(values, 0.0F);
    for (std::size_t v = 0; v < values; ++v) {
        double sum = 0;
        for (const auto& tile : tiles)
            sum += static_cast<double>(tile[v]);
        m_mean[v] = static_cast<float>(sum / m_tiles);
        for (auto& tile : tiles)
            tile[v] -= m_mean[v];
    }
    Eigen::MatrixXd products(m_tiles, m_tiles);
    context.parallel(0, m_tiles, [&](int j) {
        for (int k = 0; k <= j; ++k) {
            context.check();
            const auto &one = tiles[static_cast<std::size_t>(j)], &two = tiles[static_cast<std::size_t>(k)];
            double sum = 0;
            for (std::size_t v = 0; v < values; ++v)
                sum += static_cast<double>(one[v]) * static_cast<double>(two[v]);
            products(j, k) = products(k, j) = sum / m_tiles;
        }
    });
    const double total = products.trace();
    const CovarianceAxes axes = covarianceAxes(products);
    context.check();
    int count = 0;
    while (count < bases && axes.variances[count] > kLeastVariance * total)
        m_variances.push_back(axes.variances[count++]);
    m_share = 0;
    for (const double variance : m_variances)
        m_share += total > 0 ? variance / total : 0;
    m_components.assign(static_cast<std::size_t>(count) * values, 0.0F);
    m_coefficients.assign(static_cast<std::size_t>(count) * tiles.size(), 0.0F);
    const auto channels = static_cast<std::size_t>(m_channels), number = static_cast<std::size_t>(count);
    context.parallel(0, count, [&](int i) {
        const double length = std::sqrt(m_tiles * m_variances[static_cast<std::size_t>(i)]);
        for (std::size_t j = 0; j < tiles.size(); ++j)
            m_coefficients[j * number + static_cast<std::size_t>(i)] =
                static_cast<float>(length * axes.directions(static_cast<Eigen::Index>(j), i));
        for (std::size_t v = 0; v < values; ++v) {
            double sum = 0;
            for (std::size_t j = 0; j < tiles.size(); ++j)
                sum += axes.directions(static_cast<Eigen::Index>(j), i) * static_cast<double>(tiles[j][v]);
            m_components[(v / channels * number + static_cast<std::size_t>(i)) * channels + v % channels] =
                static_cast<float>(sum / length);
        }
    });
}

std::vector<float> TileFamily::coefficients(int index) const {
    const auto from = m_coefficients.begin() + static_cast<std::ptrdiff_t>(index) * bases();
    return {from, from + bases()};
}

std::vector<float> TileFamily::drawn(Draw draw, int a, int b, const Random& random) const {
    std::vector<float> values;
    for (int i = 0; i < bases(); ++i) {
        const auto n = static_cast<std::uint32_t>(i);
        const auto index = static_cast<std::size_t>(i);
        if (draw == Draw::Normal)
            values.push_back(static_cast<float>(std::sqrt(m_variances[index]) * random.normal(a, b, n)));
        else
            values.push_back(m_coefficients[static_cast<std::size_t>(
                                                random.below(static_cast<std::uint32_t>(m_tiles), a, b, n)) *
                                                m_variances.size() +
                                            index]);
    }
    return values;
}

void TileFamily::add(const std::vector<float>& coefficients, int dx, int dy, float weight, float* to) const {
    const auto pixel = static_cast<std::size_t>(at(dx, dy)), channels = static_cast<std::size_t>(m_channels);
    const float* component = m_components.data() + pixel * coefficients.size() * channels;
    for (std::size_t c = 0; c < channels; ++c)
        to[c] += weight * m_mean[pixel * channels + c];
    for (const float coefficient : coefficients)
        for (std::size_t c = 0; c < channels; ++c)
            to[c] += weight * coefficient * *component++;
}

Image TileFamily::picture() const {
    const Size one = m_box.size;
    Image all({one.width * (1 + bases()), 2 * one.height}, m_channels);
    std::vector<float> pixel(static_cast<std::size_t>(m_channels));
    for (int column = 0; column <= bases(); ++column)
        for (int row = 0; row < 2; ++row) {
            std::vector<float> coefficients(m_variances.size(), 0.0F);
            if (column > 0) {
                const auto index = static_cast<std::size_t>(column - 1);
                coefficients[index] = static_cast<float>((row == 0 ? 2 : -2) * std::sqrt(m_variances[index]));
            }
            for (int y = 0; y < one.height; ++y)
                for (int x = 0; x < one.width; ++x) {
                    if (!has(m_box.x + x, m_box.y + y))
                        continue;
                    std::fill(pixel.begin(), pixel.end(), 0.0F);
                    add(coefficients, m_box.x + x, m_box.y + y, 1, pixel.data());
                    for (int c = 0; c < m_channels; ++c)
                        all(column * one.width + x, row * one.height + y, c) =
                            pixel[static_cast<std::size_t>(c)];
                }
        }
    return all;
}

std::uint64_t TileFamily::bytesFor(Size exemplar, int channels) {
    // With their margins, of half a tile at most, tiles hold each pixel up to four times, once as they are
    // and once as components; the picture takes as much twice.
    const auto tiles = static_cast<std::uint64_t>(kMostTiles);
    return 20 * Image::bytesFor(exemplar, channels) + 4 * tiles * tiles * sizeof(double) +
           16 * static_cast<std::uint64_t>(exemplar.area()) * sizeof(int) + (4U << 20);
}

} // namespace texloom::regular_tile
