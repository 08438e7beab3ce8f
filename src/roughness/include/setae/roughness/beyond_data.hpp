// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/estimate.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// What waves shorter than the finest data would add if the spectrum went on as it ends.
///
///   C(q) = C(q_e) (q/q_e)^p,  q_e < q <= q_s
///
/// p: least squares of ln C over the last decade of the band. Intervals: p ± 1.96 times its standard error, which is
/// taken for 0.2 where it is smaller: no spectrum is straight beyond what its data show.
struct BeyondData {
    double end = 0.0;                     ///< q_e [1/m]
    double up_to = 0.0;                   ///< q_s [1/m]
    Estimate exponent;                    ///< p, of C_iso (of C1D one less)
    Estimate rms_slope;                   ///< h' with these waves [1]
    Estimate excess_area;                 ///< r − 1 with them
    Estimate elastic_energy_per_modulus;  ///< U_el/(A E*) with them [m]
};

/// up_to: q_s [1/m], above the end of the curve's band.
/// @throws InvalidArgument for one that is not, or modes; UndefinedDataError for fewer than three nodes in the last
/// decade.
[[nodiscard]] BeyondData beyond_data(const spectra::Spectrum& curve, double up_to);

}  // namespace setae::roughness
