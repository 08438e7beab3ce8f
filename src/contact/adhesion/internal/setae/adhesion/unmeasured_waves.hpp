// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/adhesion/prediction.hpp"
#include "setae/roughness/beyond_data.hpp"

namespace setae::adhesion {

/// What the waves beyond both ends of a surface's data would add.
struct UnmeasuredWaves {
    const roughness::SpectralParameters& within;  ///< of the band they lie beyond
    const std::optional<roughness::BeyondData>& shorter;
    const std::optional<roughness::BeyondData>& longer;
};

/// W_app by (7) with waves that were not measured: the spectrum goes on at its ends as roughness::beyond_data() has it.
///
///   h'² and U_el/(A_app E*) are sums over waves: those of the band, of the shorter and of the longer ones
///
/// Nothing where neither end is given. Interval: least and most over both ends' exponents ± 1.96 of their errors, all
/// else at its value, so that it tells what the unmeasured waves leave open and nothing more.
/// work_of_adhesion: W_int [J/m²], >= 0.
/// Source: [D19] (7), (8).
[[nodiscard]] std::optional<Estimate> work_with_unmeasured_waves(const RoughSide& rough, const SoftSide& soft,
                                                                 double work_of_adhesion, const UnmeasuredWaves& waves);

}  // namespace setae::adhesion
