// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/parallel/for_each.hpp"
#include "setae/texture/measurement_view.hpp"

namespace setae::texture {

/// Moments and extremes of heights about their mean.
///
///   Sq² = ⟨z²⟩,  Ssk = ⟨z³⟩/Sq³,  Sku = ⟨z⁴⟩/Sq⁴,  Sa = ⟨|z|⟩,  Sp = max z,  Sv = −min z,  Sz = Sp + Sv,   z = h − ⟨h⟩
///
/// Maps and lines: over defined points. Polylines: exact integrals over the segments, split at the mean line for Sa.
/// For lines R replaces S. Ssk and Sku of a constant surface are NaN. Source: ISO 25178-2:2021, 4.2; ISO 21920-2:2021,
/// 4.2.
struct HeightParameters {
    double Sq = 0.0;    ///< [m]
    double Ssk = 0.0;   ///< [1]
    double Sku = 0.0;   ///< [1], 3 for a Gaussian
    double Sp = 0.0;    ///< [m]
    double Sv = 0.0;    ///< [m]
    double Sz = 0.0;    ///< [m]
    double Sa = 0.0;    ///< [m]
    double mean = 0.0;  ///< [m]
    Index defined = 0;  ///< number of points used
};

/// Two passes: the mean, then the moments about it, so an offset causes no loss of digits. mean_line: reference height
/// [m] of z instead of the mean, such as the 0 of filtered profiles. @throws UndefinedDataError if no height is
/// defined.
[[nodiscard]] HeightParameters height_parameters(const MeasurementView& measurement, parallel::Threads threads = {},
                                                 std::optional<double> mean_line = {});

}  // namespace setae::texture
