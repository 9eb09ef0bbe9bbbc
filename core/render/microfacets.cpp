#include "core/render/microfacets.h"

#include "core/base/at.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace texloom {

namespace {

using Eigen::Vector3f;

constexpr int kSide = 32;          ///< of the table
constexpr int kTableSamples = 256; ///< of each of its values

/// The bits of a number in reverse, as a fraction: van der Corput's sequence.
float reversed(std::uint32_t bits) {
    std::uint32_t turned = 0;
    for (int i = 0; i < 32; ++i, bits >>= 1U)
        turned = turned << 1U | (bits & 1U);
    return static_cast<float>(turned >> 8U) / static_cast<float>(1U << 24U);
}

/// Smith's shadowing and masking of GGX, over 4 times the cosines (Heitz 2014).
float visibility(float toViewer, float toLight, float alpha) {
    const float square = alpha * alpha;
    const float viewer = toLight * std::sqrt(toViewer * toViewer * (1 - square) + square);
    const float light = toViewer * std::sqrt(toLight * toLight * (1 - square) + square);
    return 0.5F / std::max(viewer + light, 1e-7F);
}

Reflected integrated(float cosine, float roughness) {
    const Vector3f viewer(std::sqrt(1 - cosine * cosine), 0, cosine);
    const float alpha = roughness * roughness;
    Reflected sum;
    for (int i = 0; i < kTableSamples; ++i) {
        const Vector3f half = lobeDirection(i, kTableSamples, roughness, Vector3f::UnitZ());
        const float between = std::max(viewer.dot(half), 1e-6F);
        const Vector3f light = 2 * between * half - viewer;
        if (light.z() <= 0)
            continue;
        const float share = 4 * visibility(cosine, light.z(), alpha) * light.z() * between / half.z();
        const float fresnel = std::pow(1 - between, 5.0F);
        sum.scale += share * (1 - fresnel) / kTableSamples;
        sum.bias += share * fresnel / kTableSamples;
    }
    return sum;
}

} // namespace

Vector3f lobeDirection(int i, int count, float roughness, const Vector3f& normal) {
    const float alpha = std::max(roughness * roughness, 1e-4F);
    const float first = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    const float around = 2 * std::numbers::pi_v<float> * reversed(static_cast<std::uint32_t>(i));
    const float cosine = std::sqrt((1 - first) / (1 + (alpha * alpha - 1) * first));
    const float sine = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    const Vector3f other =
        std::abs(normal.y()) < 0.99F ? Vector3f(Vector3f::UnitY()) : Vector3f(Vector3f::UnitX());
    const Vector3f right = other.cross(normal).normalized(), up = normal.cross(right);
    return sine * (std::cos(around) * right + std::sin(around) * up) + cosine * normal;
}

const SplitSum& SplitSum::table() {
    static const SplitSum table;
    return table;
}

SplitSum::SplitSum() {
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            m_values.push_back(
                integrated((static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide));
}

Reflected SplitSum::at(float cosine, float roughness) const {
    const float x = std::clamp(cosine * kSide - 0.5F, 0.0F, static_cast<float>(kSide - 1));
    const float y = std::clamp(roughness * kSide - 0.5F, 0.0F, static_cast<float>(kSide - 1));
    const int left = std::min(static_cast<int>(x), kSide - 2), top = std::min(static_cast<int>(y), kSide - 2);
    const float right = x - static_cast<float>(left), bottom = y - static_cast<float>(top);
    const auto value = [&](int column, int row) { return m_values[texloom::at(row * kSide + column)]; };
    const auto mix = [&](float Reflected::*part) {
        return (1 - bottom) * ((1 - right) * value(left, top).*part + right * value(left + 1, top).*part) +
               bottom * ((1 - right) * value(left, top + 1).*part + right * value(left + 1, top + 1).*part);
    };
    return {mix(&Reflected::scale), mix(&Reflected::bias)};
}

} // namespace texloom
