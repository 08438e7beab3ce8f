// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/estimate.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// Contribution of waves beyond an end of the data, for an extrapolated spectrum.
///
///   C_iso(q) = C_iso(q_e) (q/q_e)^p,  q between q_e and q_s
///
/// p and C_iso(q_e): least squares of ln C over the decade of the band next to the end; of C1D by the Abel integral of
/// a power law, C_iso = 2 √π Γ(n/2)/Γ((n − 1)/2) C1D/q with n = −p > 1, and no further waves for n <= 1. Modes are
/// first averaged in ten bins per decade. Parameters: those of the band plus the moments of the waves between q_e and
/// q_s. Intervals: p ± 1.96 times its standard error, which is at least 0.2 because a spectrum is not a straight line
/// beyond its data. For long waves p is limited to −4 (Hurst exponent 1) … 0.
struct BeyondData {
    double end = 0.0;                     ///< q_e [1/m]
    double up_to = 0.0;                   ///< q_s [1/m]
    Estimate exponent;                    ///< p
    Estimate rms_height;                  ///< h_rms including these waves [m]
    Estimate rms_slope;                   ///< h' including these waves [1]
    Estimate excess_area;                 ///< r − 1 including these waves
    Estimate elastic_energy_per_modulus;  ///< U_el/(A E*) including these waves [m]
};

/// up_to: q_s [1/m], above the band of the curve for shorter waves, below it for longer ones.
/// @throws InvalidArgument for q_s inside the band; UndefinedDataError for fewer than three nodes in the decade.
[[nodiscard]] BeyondData beyond_data(const spectra::Spectrum& curve, double up_to);

}  // namespace setae::roughness
