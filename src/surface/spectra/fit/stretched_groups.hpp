// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "observed_groups.hpp"
#include "setae/spectral_fit/stretch.hpp"
#include "whittle_fit.hpp"

namespace setae::spectral_fit {

/// A stretch and what it is known to.
struct KnownStretch {
    StretchLaw law;
    Eigen::MatrixXd information;  ///< of law.values(), by maps and by what is expected before
};

/// Whether groups have lines along several directions.
[[nodiscard]] bool several_directions(const std::vector<ObservedGroup>& groups);

/// What lines along several directions begin with where maps show no stretch: none, a knot a decade of the band, s
/// within a factor of e of 1 and within 1.35 of that a decade away (standard deviations).
[[nodiscard]] KnownStretch unknown_stretch(const Band& band);

/// The lengths of each group's lines at its nodes, and where C_iso ends: `shortest` is the surface's largest wavevector
/// in any direction, that across the long one [1/m].
void take_stretch(std::vector<ObservedGroup>& groups, const StretchLaw& law, double shortest);

/// Where C_iso ends [1/m]: across the long direction that is `shortest`.
[[nodiscard]] double surface_end(const StretchLaw& law, double shortest);

/// Largest wavevector of the surface that lines along a direction see [1/m].
[[nodiscard]] double lines_end(const StretchLaw& law, double shortest, double direction);

/// ∂ ln E/∂ law.values() of each group, by central differences.
[[nodiscard]] std::vector<Eigen::MatrixXd> answers_to_stretch(const std::vector<ObservedGroup>& groups,
                                                              const LogSpline& spline, const WhittleFit& fit,
                                                              const StretchLaw& law);

/// A step of Fisher scoring for the stretch, with what the spectrum would follow of it taken off:
///
///   I = DᵀνD − DᵀνJ (JᵀνJ + Q)⁻¹ JᵀνD + Π,  δ = I⁻¹ (Dᵀν(P/E − 1) − Π (law − known))
struct StretchStep {
    StretchLaw law;
    Eigen::MatrixXd covariance;  ///< I⁻¹
};
[[nodiscard]] StretchStep stretch_step(const std::vector<ObservedGroup>& groups, const LogSpline& spline,
                                       const WhittleFit& fit, const StretchLaw& law, const KnownStretch& known);

/// ln of the mean over directions of C2D(q), C_iso of the stretched surface, and its derivative by theta.
struct DirectionMean {
    Array1D log_density;
    Eigen::MatrixXd design;
};
[[nodiscard]] DirectionMean direction_mean(const LogSpline& spline, const Eigen::VectorXd& theta, const StretchLaw& law,
                                           const Array1D& wavevector);

/// C_iso that lines along the long direction, turned by `turn`, show: C(q/μ)/μ².
[[nodiscard]] Array1D density_of_lines(const LogSpline& spline, const Eigen::VectorXd& theta, const StretchLaw& law,
                                       const Array1D& wavevector, double turn);

}  // namespace setae::spectral_fit
