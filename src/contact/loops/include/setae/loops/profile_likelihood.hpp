// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/jkr_fits.hpp"

namespace setae::loops {

/// Fits whose likelihood can be profiled.
enum class ProfiledFit { effective_variance, force_displacement, joint };

struct ProfileOptions {
    ProfiledFit fit = ProfiledFit::effective_variance;
    double level = 0.95;
    Index points = 41;    ///< number of points of each curve
    double reach = 1.25;  ///< extent of the curves, in half widths of the interval on each side
};

/// Rise of χ² where one parameter is fixed and all others are fitted again.
struct ParameterProfile {
    /// estimate of the fit, with the profile's interval; no interval where an end lies beyond ten standard errors
    Estimate estimate;
    Array1D values;          ///< values of the parameter, SI, increasing
    Array1D chi2_rise;       ///< Δχ² at each value, in units of the noise of the fit
    double threshold = 0.0;  ///< Δχ² at the ends of the interval: t² of the fit's degrees of freedom
};

struct ProfileLikelihood {
    ParameterProfile contact_modulus;   ///< E* [Pa]
    ParameterProfile work_of_adhesion;  ///< W [J/m²]
    JkrFit fit;
};

/// Intervals of E* and of W by the drop of the profile likelihood, which need not be symmetric.
///
///   Δχ²(θ) = [S(θ) − S_min]/φ,  S(θ) = minimum of Σ distance² at fixed θ
///
/// S in units of the given noise; φ = (fit's variance of θ)/(that of independent residuals of unit variance), so that
/// scatter and correlations of residuals widen the profile like the standard error.
/// @throws UndefinedDataError where the fit has no covariance; else as the fit, with InvalidArgument where the noise of
/// a channel is unknown, for fewer than 3 points, level outside (0, 1) or reach <= 0. Source: Venzon, Moolgavkar, J. R.
/// Stat. Soc. C 37 (1988) 87. Cost: one fit, from a near start, for each point.
[[nodiscard]] ProfileLikelihood profile_likelihood(const BranchData& data, const LensAndCounterBody& bodies,
                                                   const ProfileOptions& options = {});

/// Joint confidence region of E* and W at a given level.
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
