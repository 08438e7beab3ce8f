// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "observed_groups.hpp"
#include "setae/spectral_fit/stretch.hpp"
#include "whittle_fit.hpp"

namespace setae::spectral_fit {

/// A stretch and its information matrix.
struct KnownStretch {
    StretchLaw law;
    Eigen::MatrixXd information;  ///< of law.values(), from maps and prior
};

/// Whether groups have lines along several directions.
[[nodiscard]] bool several_directions(const std::vector<ObservedGroup>& groups);

/// Prior for lines along several directions if maps show no stretch: none, one knot per decade of the band, s within a
/// factor of e of 1 and within 1.35 of that a decade away (standard deviations).
[[nodiscard]] KnownStretch unknown_stretch(const Band& band);

/// Lengths of the lines of each group at its nodes, and the end of C_iso: `shortest` is the largest wavevector of the
/// surface in any direction, that across the long one [1/m].
void take_stretch(std::vector<ObservedGroup>& groups, const StretchLaw& law, double shortest);

/// End of C_iso [1/m]; across the long direction it is `shortest`.
[[nodiscard]] double surface_end(const StretchLaw& law, double shortest);

/// Largest wavevector of the surface for lines along a direction [1/m].
[[nodiscard]] double lines_end(const StretchLaw& law, double shortest, double direction);

/// ∂ ln E/∂ law.values() of each group, by central differences.
[[nodiscard]] std::vector<Eigen::MatrixXd> answers_to_stretch(const std::vector<ObservedGroup>& groups,
                                                              const LogSpline& spline, const WhittleFit& fit,
                                                              const StretchLaw& law);

/// A step of Fisher scoring for the stretch, after elimination of the response of the spectrum:
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

/// C_iso for lines at the angle `turn` to the long direction: C(q/μ)/μ².
[[nodiscard]] Array1D density_of_lines(const LogSpline& spline, const Eigen::VectorXd& theta, const StretchLaw& law,
                                       const Array1D& wavevector, double turn);

}  // namespace setae::spectral_fit
