// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/pair_point.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"

namespace setae::adhesion {

/// Measured work of adhesion of a pair and its prediction.
struct PredictionResidual {
    std::string surface, elastomer;
    Estimate measured;            ///< W_app of loading [J/m²]
    Estimate predicted;           ///< max(0, Eq. 7) at W_int [J/m²]; its standard error without that of a fitted W_int
    double residual = 0.0;        ///< measured − predicted [J/m²]
    double standard_error = 0.0;  ///< standard error of the residual, from both errors [J/m²]

    /// Residual in standard errors.
    [[nodiscard]] double standardised() const { return residual / standard_error; }
};

/// Test of whether predictions explain the measurements within both errors.
///
///   χ² = rᵀC⁻¹r − (sᵀC⁻¹r)²/(sᵀC⁻¹s)
///
/// r: residuals.  C: their covariance: measured variances on the diagonal, and shared inputs, such as the spectrum of a
/// surface, the modulus and the surface energy of an elastomer, a lens, a given W_int.  s: ∂prediction/∂W_int, where
/// W_int was fitted to the same values: the second term then takes the W_int that minimises χ² with C, to first order,
/// at the cost of one degree of freedom.
struct PredictionTest {
    std::vector<PredictionResidual> pairs;
    std::vector<std::string> left_out;  ///< "A × B: no standard error of the measured value"
    bool work_fitted = false;           ///< whether W_int was fitted to these values
    int n = 0;
    int degrees_of_freedom = 0;
    double chi_squared = 0.0;
    double probability = 1.0;  ///< probability of a χ² at least as large if the predictions are correct
    /// scatter τ >= 0 of the model [J/m²]: with C + τ² 1, χ² is equal to its degrees of freedom or less
    double extra_scatter = 0.0;
    double chi_squared_with_scatter = 0.0;
    double probability_with_scatter = 1.0;
};

/// The test of residuals with a covariance.
/// slopes: s, where W_int was fitted; absent where it was given.
/// @throws InvalidArgument where sizes differ or no degree of freedom is left; UndefinedDataError for a covariance that
/// is not positive definite.
[[nodiscard]] PredictionTest prediction_test(std::vector<PredictionResidual> pairs, const Array2D& covariance,
                                             const std::optional<Array1D>& slopes);

/// The test of pairs at one W_int: lines of the full-contact balance (Eq. 7) with measured values that have a standard
/// error. Residuals share the inputs of predictions (the spectrum of a surface, modulus and surface energy of an
/// elastomer, a given W_int) and of measured values (lenses, calibrations); below the floor at 0 a prediction has the
/// part of its error that exceeds the floor.
/// work_fitted: W_int was fitted to the same values.
/// @throws UndefinedDataError for fewer than one pair, or two where W_int was fitted; as prediction_test().
[[nodiscard]] PredictionTest test_predictions(const std::vector<PairPoint>& pairs, const TracedValue& work_of_adhesion,
                                              bool work_fitted);

}  // namespace setae::adhesion
