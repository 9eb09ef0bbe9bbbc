#include "core/methods/portilla_simoncelli/low_residuals.h"

#include "core/base/at.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::portilla_simoncelli {

namespace {

constexpr std::array<std::array<int, 2>, kNeighbours> kShifts{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

using Complex = SteerablePyramid::Complex;
using Check = SteerablePyramid::Check;
using Samples = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The factors that shift a column of a spectrum to a neighbour.
std::vector<Complex> shiftFactors(const SteerablePyramid& pyramid, int column, int neighbour) {
    const int scale = pyramid.scales();
    std::vector<Complex> factors(at(pyramid.size(scale).height));
    for (int row = 0; row < pyramid.size(scale).height; ++row)
        factors[at(row)] = std::polar(
            1.0F, static_cast<float>(kShifts[at(neighbour)][0] * pyramid.frequencyX(scale, column) +
                                     kShifts[at(neighbour)][1] * pyramid.frequencyY(scale, row)));
    return factors;
}

/// One column of the spectra, shifted to each neighbour: real parts, then imaginary parts.
Samples shiftedColumn(const SteerablePyramid& pyramid, const LowSpectra& low, int column) {
    const int height = pyramid.size(pyramid.scales()).height, components = static_cast<int>(low.size());
    const std::ptrdiff_t offset = column * pyramid.fft(pyramid.scales()).columnStride();
    Samples samples(kNeighbours * components, 2 * height);
    for (int j = 0; j < kNeighbours; ++j) {
        const std::vector<Complex> factors = shiftFactors(pyramid, column, j);
        for (int c = 0; c < components; ++c) {
            const Complex* bins = low[at(c)].data() + offset;
            for (int row = 0; row < height; ++row) {
                const Complex value = bins[row] * factors[at(row)];
                samples(kNeighbours * c + j, row) = value.real();
                samples(kNeighbours * c + j, height + row) = value.imag();
            }
        }
    }
    return samples;
}

/// Sets a column of the spectra from its neighbours after a map.
void layColumn(const SteerablePyramid& pyramid, const Samples& mixed, int column, const LowSpectra& low) {
    const int height = pyramid.size(pyramid.scales()).height;
    const std::ptrdiff_t offset = column * pyramid.fft(pyramid.scales()).columnStride();
    for (const FftBuffer<Complex>& spectrum : low)
        std::fill_n(spectrum.data() + offset, height, Complex(0, 0));
    for (int j = 0; j < kNeighbours; ++j) {
        const std::vector<Complex> factors = shiftFactors(pyramid, column, j);
        for (int variable = j; variable < mixed.rows(); variable += kNeighbours) {
            Complex* bins = low[at(variable / kNeighbours)].data() + offset;
            for (int row = 0; row < height; ++row)
                bins[row] += Complex(mixed(variable, row), mixed(variable, height + row)) *
                             std::conj(factors[at(row)]) / static_cast<float>(kNeighbours);
        }
    }
}

} // namespace

Eigen::MatrixXd lowCovariance(const SteerablePyramid& pyramid, const LowSpectra& low, const Check& check) {
    const int width = pyramid.size(pyramid.scales()).width;
    const auto variables = kNeighbours * static_cast<Eigen::Index>(low.size());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(variables, variables);
    for (int column = 0; column < pyramid.fft(pyramid.scales()).columns(); ++column) {
        check();
        const Eigen::MatrixXd samples = shiftedColumn(pyramid, low, column).cast<double>();
        covariance += (column == 0 || 2 * column == width ? 1 : 2) * samples * samples.transpose();
    }
    return covariance;
}

void mixLow(const SteerablePyramid& pyramid, const Eigen::MatrixXf& map, const LowSpectra& low,
            const Check& check) {
    for (int column = 0; column < pyramid.fft(pyramid.scales()).columns(); ++column) {
        check();
        const Samples mixed = map * shiftedColumn(pyramid, low, column);
        layColumn(pyramid, mixed, column, low);
    }
}

FftBuffer<Complex> shiftedLow(const SteerablePyramid& pyramid, const FftBuffer<Complex>& low, int neighbour,
                              const Check& check) {
    const int scale = pyramid.scales();
    FftBuffer<Complex> shifted = pyramid.spectrum(scale);
    for (int column = 0; column < pyramid.fft(scale).columns(); ++column) {
        check();
        const std::ptrdiff_t offset = column * pyramid.fft(scale).columnStride();
        const std::vector<Complex> factors = shiftFactors(pyramid, column, neighbour);
        for (int row = 0; row < pyramid.size(scale).height; ++row)
            shifted.data()[offset + row] = low.data()[offset + row] * factors[at(row)];
    }
    return shifted;
}

} // namespace texloom::portilla_simoncelli
