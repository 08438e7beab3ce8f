// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "setae/contact/crack_speed.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"
#include "setae/fields/describe.hpp"

namespace setae::loops {

/// Record of a retracting contact edge.
struct RetractingEdge {
    Array1D time;                       ///< [s], increasing
    Array1D force;                      ///< F [N], relative to its zero
    Array1D contact_radius;             ///< a [m]; NaN between camera frames
    double contact_radius_noise = 0.0;  ///< σ_a [m]; 0: unknown, determined from the residuals
};

struct CrackSpeedOptions {
    std::optional<double> exponent;  ///< n where known, else fitted
};

/// G(v) = G0 [1 + (v/v0)^n] of an edge, and the resulting radii.
struct CrackSpeedFit {
    contact::crack_speed::Law law;
    Estimate threshold;                                    ///< G0 [J/m²]
    Estimate reference_speed;                              ///< v0 [m/s]
    Estimate exponent;                                     ///< n; without error where given
    Estimate contact_modulus;                              ///< E* [Pa], from the given value and this branch together
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< covariance of G0, v0, n, E*
    bool converged = false;
    int iterations = 0;
    Index n = 0;                     ///< number of frames
    Array1D residuals;               ///< a − a(t) [m] of the frames
    double relative_residual = 0.0;  ///< rms of the residuals divided by the range of a
    double chi2_reduced = 0.0;       ///< NaN where σ_a is not known
    double slow_speed = 0.0;         ///< 5th percentile of the fitted speeds of retraction [m/s]
    double speed_ratio = 0.0;        ///< 95th divided by 5th percentile of these speeds
    double modulus_deviation =
        0.0;  ///< deviation of the given E* from that of this fit, divided by its standard error; NaN without one
};

/// Fits the dependence of G on crack speed to the radii of a retracting edge.
///
/// The edge follows da/dt = −v(G(a, F(t))), G = (4E*a³/3R − F)²/(8πE*a³), v = v0 (G/G0 − 1)^(1/n) and 0 for G < G0. The
/// radii computed from the measured force are fitted to the measured ones by least squares in a; no radius is
/// differentiated. Parameters are the first radius, G0, v0, n and E*, the last constrained by the given value with its
/// standard error. E* of the same branch fitted with a constant W includes the increase of G with speed; that of
/// loading does not.
///
/// The standard error of v0 includes 1.5 % of the method, as found for records without noise.
///
/// radius: R of the sphere [m]; contact_modulus: E* [Pa] of the loading branch; without a standard error it is fixed.
/// @throws InvalidArgument for series of different length, a time that does not increase, undefined forces, R, E* or n
/// <= 0; UndefinedDataError with the reason: fewer frames than 8, an edge that does not retract, parameters that the
/// data do not determine: ln G0, ln v0 or ln n uncertain by more than 1. Sources: Maugis, Barquins, J. Phys. D 11
/// (1978) 1989; Gent, Schultz, J. Adhesion 3 (1972) 281.
[[nodiscard]] CrackSpeedFit fit_crack_speed(const RetractingEdge& edge, double radius, const Estimate& contact_modulus,
                                            const CrackSpeedOptions& options = {});

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::CrackSpeedFit> {
    using T = loops::CrackSpeedFit;
    static constexpr std::array rows{
        field<&T::converged>("converged", "whether the iteration converged"),
        field<&T::n>("n", "number of points, measurements or pairs"),
        quantity<&T::threshold>("threshold", "G0", "J/m2", "G0"),
        quantity<&T::reference_speed>("reference_speed", "v0", "m/s", "v0"),
        quantity<&T::exponent>("exponent", "n", "1", "n").as("speed_exponent"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "E*"),
        field<&T::modulus_deviation>("modulus_deviation", "deviation of E* from E* of the loop"),
        made<T>("covariance", "covariance of the parameters",
                [](const T& of) { return Eigen::MatrixXd(of.covariance); }),
        field<&T::chi2_reduced>("chi_squared_reduced", "χ² divided by the degrees of freedom"),
        field<&T::relative_residual>("relative_residual", "rms residual divided by the rms of the fitted values"),
        field<&T::speed_ratio>("speed_ratio", "largest divided by smallest speed"),
        field<&T::residuals>("residuals", "measured minus fitted values"),
        inner<&T::law>(),
        inner<&T::covariance>(),
        inner<&T::iterations>(),
        inner<&T::slow_speed>(),
    };
    static constexpr Description description{"crack_speed", "G0 (1 + (v/v0)^n) fitted to the speed of the crack", rows};
};
static_assert(complete<loops::CrackSpeedFit>);

}  // namespace setae::fields
