// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/jkr_fits.hpp"

namespace setae::loops {

/// Region of E* and W that holds both together at a level of confidence.
struct ErrorEllipse {
    double level = 0.95;
    Array1D contact_modulus;   ///< [Pa], points around the ellipse, the first again at the end
    Array1D work_of_adhesion;  ///< [J/m²]
};

/// Boundary (x − x̂)ᵀ C⁻¹ (x − x̂) = 2 F⁻¹(level; 2, ν), C the fit's covariance of (E*, W), ν its degrees of freedom.
///
/// F⁻¹ of two numerator degrees has the closed form ν/2 ((1 − level)^(−2/ν) − 1); −ln(1 − level) for ν → ∞.
/// @throws InvalidArgument unless 0 < level < 1; UndefinedDataError where the fit has no covariance.
[[nodiscard]] ErrorEllipse error_ellipse(const JkrFit& fit, double level = 0.95);

}  // namespace setae::loops
