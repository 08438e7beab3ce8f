// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/adhesion/prediction.hpp"
#include "setae/roughness/beyond_data.hpp"

namespace setae::adhesion {

/// Contributions of the waves beyond both ends of a surface's data.
struct UnmeasuredWaves {
    const roughness::SpectralParameters& within;  ///< parameters of the measured band
    const std::optional<roughness::BeyondData>& shorter;
    const std::optional<roughness::BeyondData>& longer;
};

/// W_app by the full-contact balance (Eq. 7) with waves that were not measured: the spectrum is extrapolated at its
/// ends by roughness::beyond_data().
///
///   h'² and U_el/(A_app E*) are sums over waves: those of the band, of the shorter and of the longer ones
///
/// Empty where neither end is given. Interval: smallest and largest value over both ends' exponents ± 1.96 of their
/// errors, with all else at its value, so that it contains only the uncertainty of the unmeasured waves.
/// work_of_adhesion: W_int [J/m²], >= 0.
/// Source: [D19], Eqs. 7 and 8.
[[nodiscard]] std::optional<Estimate> work_with_unmeasured_waves(const RoughSide& rough, const SoftSide& soft,
                                                                 double work_of_adhesion, const UnmeasuredWaves& waves);

}  // namespace setae::adhesion
