#pragma once

#include <memory>
#include <span>
#include <vector>

namespace texloom {

/// A Gaussian vector of low rank with a little white noise, x = μ + Q a + σ e with a ~ N(0, I) and e ~ N(0,
/// I), conditioned on some of its entries: the coefficients a given those entries (Raad, thesis 2016, section
/// 3.3, with Γ = QQᵗ + σ²I). Where the source factors matrices as large as a patch, Woodbury's identity
/// reduces this to one of size m, the number of coefficients: a | q₀ ~ N((G + σ²I)⁻¹ Rᵗ d, σ² (G + σ²I)⁻¹)
/// with R the known rows of Q, G = RᵗR and d = q₀ minus the known part of μ.
class ConditionalGaussian {
public:
    /// @param rows the known rows of Q by columns: m columns of `known` values. @param known number of known
    /// entries. @param difference d. @param sigma σ, above 0.
    ConditionalGaussian(std::span<const double> rows, int known, std::span<const double> difference,
                        double sigma);
    ~ConditionalGaussian();
    ConditionalGaussian(const ConditionalGaussian&) = delete;
    ConditionalGaussian& operator=(const ConditionalGaussian&) = delete;

    /// The most probable coefficients.
    std::vector<double> mean() const;
    /// Coefficients drawn with m independent standard normal numbers.
    std::vector<double> sample(std::span<const double> normals) const;

private:
    struct Factors;
    std::unique_ptr<Factors> m_factors;
};

} // namespace texloom
