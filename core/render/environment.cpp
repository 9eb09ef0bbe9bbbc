#include "core/render/environment.h"

#include "core/base/error.h"
#include "core/render/microfacets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kChannels = 3;
constexpr Size kPanorama{256, 128};
constexpr Size kBlurred{64, 32};
constexpr int kRoughnesses = 7; ///< steps of roughness
constexpr int kSamples = 96;    ///< directions that a lobe is averaged over

Vector3f directionOf(float u, float v) {
    const float around = 2 * kPi * (u - 0.5F), down = kPi * v;
    return {std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)};
}

/// The value of a panorama in a direction, between its pixels.
Vector3f lookup(const Image& panorama, const Vector3f& direction) {
    const float u = std::atan2(direction.x(), direction.z()) / (2 * kPi) + 0.5F;
    const float v = std::acos(std::clamp(direction.y(), -1.0F, 1.0F)) / kPi;
    const float x = u * static_cast<float>(panorama.width()) - 0.5F;
    const float y = std::clamp(v * static_cast<float>(panorama.height()) - 0.5F, 0.0F,
                               static_cast<float>(panorama.height() - 1));
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(y);
    const float right = x - static_cast<float>(left), bottom = y - static_cast<float>(top);
    const int columns[] = {(left + panorama.width()) % panorama.width(), (left + 1) % panorama.width()};
    const int rows[] = {top, std::min(top + 1, panorama.height() - 1)};
    Vector3f sum = Vector3f::Zero();
    for (int c = 0; c < kChannels; ++c)
        sum[c] =
            (1 - bottom) *
                ((1 - right) * panorama(columns[0], rows[0], c) + right * panorama(columns[1], rows[0], c)) +
            bottom *
                ((1 - right) * panorama(columns[0], rows[1], c) + right * panorama(columns[1], rows[1], c));
    return sum;
}

/// The share of all directions that a row's pixels see, each.
float solidAngle(Size size, int y) {
    const auto rows = static_cast<float>(size.height);
    const float top = std::cos(kPi * static_cast<float>(y) / rows),
                bottom = std::cos(kPi * static_cast<float>(y + 1) / rows);
    return (top - bottom) * 2 * kPi / static_cast<float>(size.width);
}

/// The mean of all pixels of the panorama that fall into one of kPanorama, or the nearest.
Image reduced(const ImageView& panorama) {
    Image made(kPanorama, kChannels);
    for (int c = 0; c < kChannels; ++c)
        for (int y = 0; y < made.height(); ++y)
            for (int x = 0; x < made.width(); ++x) {
                const int left = x * panorama.width / made.width(), top = y * panorama.height / made.height();
                const int right = std::max(left + 1, (x + 1) * panorama.width / made.width());
                const int bottom = std::max(top + 1, (y + 1) * panorama.height / made.height());
                double sum = 0;
                for (int row = top; row < bottom; ++row)
                    for (int column = left; column < right; ++column)
                        sum += static_cast<double>(panorama(column, row, c));
                made(x, y, c) = std::max(0.0F, static_cast<float>(sum / ((right - left) * (bottom - top))));
            }
    return made;
}

std::array<float, 9> harmonicsOf(const Vector3f& d) {
    return {0.282095F,
            0.488603F * d.y(),
            0.488603F * d.z(),
            0.488603F * d.x(),
            1.092548F * d.x() * d.y(),
            1.092548F * d.y() * d.z(),
            0.315392F * (3 * d.z() * d.z() - 1),
            1.092548F * d.x() * d.z(),
            0.546274F * (d.x() * d.x() - d.y() * d.y())};
}

} // namespace

Environment::Environment(const ImageView& panorama, JobContext& context) {
    if (panorama.channels < kChannels)
        failUsage("A panorama needs 3 channels of light, and this one has {}; choose another picture.",
                  panorama.channels);
    m_panorama = reduced(panorama);
    normalise();
    context.check();
    findHarmonics();
    blur(context);
}

void Environment::normalise() {
    double mean = 0, all = 0;
    for (int y = 0; y < m_panorama.height(); ++y)
        for (int x = 0; x < m_panorama.width(); ++x) {
            const double angle = static_cast<double>(solidAngle(kPanorama, y));
            for (int c = 0; c < kChannels; ++c)
                mean += angle * static_cast<double>(m_panorama(x, y, c)) / kChannels;
            all += angle;
        }
    mean /= all;
    if (!(mean > 0) || !std::isfinite(mean))
        failUsage("There is no light in this panorama; choose another picture.");
    const auto most = static_cast<float>(kBrightest * mean);
    for (int pass = 0; pass < 2; ++pass) { // cut off, then scaled by what is left
        double left = 0;
        for (int c = 0; c < kChannels; ++c)
            for (int y = 0; y < m_panorama.height(); ++y)
                for (int x = 0; x < m_panorama.width(); ++x) {
                    float& value = m_panorama(x, y, c);
                    value = pass == 0 ? std::min(value, most) : value / static_cast<float>(mean);
                    left += static_cast<double>(solidAngle(kPanorama, y)) * static_cast<double>(value) /
                            kChannels;
                }
        mean = left / all;
    }
}

void Environment::findHarmonics() {
    m_harmonics.fill(Vector3f::Zero());
    for (int y = 0; y < m_panorama.height(); ++y)
        for (int x = 0; x < m_panorama.width(); ++x) {
            const std::array<float, 9> basis = harmonicsOf(
                directionOf((static_cast<float>(x) + 0.5F) / static_cast<float>(kPanorama.width),
                            (static_cast<float>(y) + 0.5F) / static_cast<float>(kPanorama.height)));
            const Vector3f light(m_panorama(x, y, 0), m_panorama(x, y, 1), m_panorama(x, y, 2));
            for (std::size_t i = 0; i < basis.size(); ++i)
                m_harmonics[i] += solidAngle(kPanorama, y) * basis[i] * light;
        }
    // What the cosine leaves of each order, over π.
    constexpr std::array<float, 9> kCosine{1,     2.0F / 3, 2.0F / 3, 2.0F / 3, 0.25F,
                                           0.25F, 0.25F,    0.25F,    0.25F};
    for (std::size_t i = 0; i < kCosine.size(); ++i)
        m_harmonics[i] *= kCosine[i];
}

void Environment::blur(JobContext& context) {
    // Lobes are averaged over a panorama that is itself coarser, so that few directions miss no light.
    Image coarse(kBlurred, kChannels);
    constexpr int kTimes = kPanorama.width / kBlurred.width;
    for (int c = 0; c < kChannels; ++c)
        for (int y = 0; y < m_panorama.height(); ++y)
            for (int x = 0; x < m_panorama.width(); ++x)
                coarse(x / kTimes, y / kTimes, c) += m_panorama(x, y, c) / (kTimes * kTimes);
    for (int step = 1; step < kRoughnesses; ++step) {
        const float roughness = static_cast<float>(step) / (kRoughnesses - 1);
        Image& blurred = m_blurred.emplace_back(kBlurred, kChannels);
        context.parallel(0, kBlurred.height, [&](int y) {
            for (int x = 0; x < kBlurred.width; ++x) {
                const Vector3f middle =
                    directionOf((static_cast<float>(x) + 0.5F) / static_cast<float>(kBlurred.width),
                                (static_cast<float>(y) + 0.5F) / static_cast<float>(kBlurred.height));
                Vector3f sum = Vector3f::Zero();
                float weights = 0;
                for (int i = 0; i < kSamples; ++i) {
                    const Vector3f half = lobeDirection(i, kSamples, roughness, middle);
                    const Vector3f light = 2 * half.dot(middle) * half - middle;
                    const float weight = light.dot(middle);
                    if (weight <= 0)
                        continue;
                    sum += weight * lookup(coarse, light);
                    weights += weight;
                }
                for (int c = 0; c < kChannels; ++c)
                    blurred(x, y, c) = sum[c] / weights;
            }
        });
    }
}

Vector3f Environment::radiance(const Vector3f& direction, float roughness) const {
    const float step = std::clamp(roughness, 0.0F, 1.0F) * (kRoughnesses - 1);
    const int lower = std::min(static_cast<int>(step), kRoughnesses - 2);
    const float share = step - static_cast<float>(lower);
    const auto level = [&](int at) -> const Image& {
        return at == 0 ? m_panorama : m_blurred[static_cast<std::size_t>(at - 1)];
    };
    return (1 - share) * lookup(level(lower), direction) + share * lookup(level(lower + 1), direction);
}

Vector3f Environment::irradiance(const Vector3f& normal) const {
    const std::array<float, 9> basis = harmonicsOf(normal);
    Vector3f sum = Vector3f::Zero();
    for (std::size_t i = 0; i < basis.size(); ++i)
        sum += basis[i] * m_harmonics[i];
    return sum.cwiseMax(0.0F);
}

Image studioPanorama() {
    Image studio(kPanorama, kChannels);
    /// 1 within a box of directions, 0 outside it, with soft edges; `u` and `v` as shares of the panorama.
    const auto box = [](float value, float from, float to, float soft) {
        return std::clamp((value - from) / soft, 0.0F, 1.0F) * std::clamp((to - value) / soft, 0.0F, 1.0F);
    };
    for (int y = 0; y < studio.height(); ++y)
        for (int x = 0; x < studio.width(); ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(studio.width());
            const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(studio.height());
            const float room = v < 0.5F ? 0.22F : 0.3F;
            const float above = 7 * box(u, 0.28F, 0.6F, 0.04F) * box(v, 0.1F, 0.3F, 0.04F);
            const float left = 4 * box(u, 0.12F, 0.24F, 0.03F) * box(v, 0.25F, 0.55F, 0.05F);
            const float strip = 9 * box(u, 0.76F, 0.8F, 0.015F) * box(v, 0.2F, 0.6F, 0.05F);
            studio(x, y, 0) = room + above + 0.94F * left + strip;
            studio(x, y, 1) = room + above + 0.98F * left + 0.98F * strip;
            studio(x, y, 2) = room + 0.97F * above + 1.06F * left + 0.93F * strip;
        }
    return studio;
}

} // namespace texloom
