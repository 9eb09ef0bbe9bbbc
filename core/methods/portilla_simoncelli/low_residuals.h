#pragma once

#include "core/math/steerable_pyramid.h"

#include <Eigen/Core>

#include <vector>

namespace texloom::portilla_simoncelli {

/// The low residual of a component counts with its four neighbours, which are the residual shifted by a
/// sample along an axis: this many variables (colour extension of the authors' code).
inline constexpr int kNeighbours = 5;

/// Spectra of the low residuals by component, in the layout of a pyramid's coarsest scale.
using LowSpectra = std::vector<FftBuffer<SteerablePyramid::Complex>>;

/// Covariances of the low residuals and their neighbours, kNeighbours variables for each component.
Eigen::MatrixXd lowCovariance(const SteerablePyramid& pyramid, const LowSpectra& low,
                              const SteerablePyramid::Check& check);

/// Applies a linear map to these variables; each neighbour's result is shifted back and averaged.
void mixLow(const SteerablePyramid& pyramid, const Eigen::MatrixXf& map, const LowSpectra& low,
            const SteerablePyramid::Check& check);

/// The spectrum of a neighbour, 0 (the residual itself) to kNeighbours - 1.
FftBuffer<SteerablePyramid::Complex> shiftedLow(const SteerablePyramid& pyramid,
                                                const FftBuffer<SteerablePyramid::Complex>& low,
                                                int neighbour, const SteerablePyramid::Check& check);

} // namespace texloom::portilla_simoncelli
