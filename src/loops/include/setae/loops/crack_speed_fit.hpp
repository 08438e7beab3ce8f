// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "setae/contact/crack_speed.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"

namespace setae::loops {

/// Speed at which a contact edge recedes, sample by sample.
struct EdgeSpeeds {
    Array1D speed;                      ///< v = −da/dt [m/s]
    Array1D standard_error;             ///< of each [m/s], from the radii's scatter about the local parabolas
    Index window = 0;                   ///< samples of each parabola
    double contact_radius_noise = 0.0;  ///< that scatter [m]
};

/// v = −da/dt by a parabola through `window` neighbouring samples, fewer on one side at the ends.
///
/// window: odd, >= 5; too wide a one flattens the last moments before pull-off. time [s] rises; missing radii are left
/// out beforehand.
/// @throws InvalidArgument for series of different length, a time that does not rise, a window out of range;
/// UndefinedDataError for fewer samples than the window.
/// Source: Savitzky, Golay, Anal. Chem. 36 (1964) 1627, here for any spacing.
[[nodiscard]] EdgeSpeeds speeds_of_edge(const ArrayView1D& time, const ArrayView1D& contact_radius, Index window = 9);

/// Energy release rate against speed of a contact edge, with what is known of the errors.
struct CrackSpeedPoints {
    Array1D speed;                               ///< v [m/s]; those <= 0 are left out: that edge heals
    Array1D energy_release_rate;                 ///< G [J/m²], > 0
    Array1D speed_standard_error;                ///< [m/s], or empty
    Array1D energy_release_rate_standard_error;  ///< [J/m²], or empty: then equal relative errors
};

struct CrackSpeedOptions {
    std::optional<double> exponent;  ///< n where known, else fitted
    double least_speed_ratio = 3.0;  ///< largest over smallest speed: a smaller span tells no law
};

/// G(v) = G0 [1 + (v/v0)^n] by least squares.
struct CrackSpeedFit {
    contact::crack_speed::Law law;
    Estimate threshold;                                    ///< G0 [J/m²]
    Estimate reference_speed;                              ///< v0 [m/s]
    Estimate exponent;                                     ///< n; without error where given
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of G0, v0, n
    bool converged = false;
    int iterations = 0;
    Index n = 0;
    Index left_out = 0;              ///< points with v <= 0
    Array1D residuals;               ///< G − G(v) [J/m²] of the points kept
    double relative_residual = 0.0;  ///< rms of the residuals over G
    double chi2_reduced = 0.0;       ///< NaN where the errors of G are not known
    double speed_ratio = 0.0;        ///< largest over smallest speed
};

/// Fits the crack-speed law; errors of speed count through dG/dv (effective variance).
///
/// @throws UndefinedDataError with the reason: fewer than 4 points that recede, speeds that span less than the ratio, a
/// G that does not rise with speed, a G0 that the data do not hold off zero; InvalidArgument for series of different
/// length or n <= 0. Sources: Maugis, Barquins, J. Phys. D 11 (1978) 1989; Gent, Schultz, J. Adhesion 3 (1972) 281.
[[nodiscard]] CrackSpeedFit fit_crack_speed(const CrackSpeedPoints& points, const CrackSpeedOptions& options = {});

/// The points of an unloading branch: speeds_of_edge of its measured radii, and G of the same samples.
/// @throws as speeds_of_edge, and InvalidArgument for series of different length.
[[nodiscard]] CrackSpeedPoints crack_speed_points(const ArrayView1D& time, const ArrayView1D& contact_radius,
                                                  const ArrayView1D& energy_release_rate, Index window = 9);

}  // namespace setae::loops
