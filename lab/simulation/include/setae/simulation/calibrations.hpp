// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/simulation/stated_quantity.hpp"

namespace setae::simulation {

/// Factors of one instrument, of all that it measures on all surfaces: true length = factor × stated length.
struct InstrumentCalibration {
    std::optional<StatedQuantity> height;   ///< of heights [1], > 0
    std::optional<StatedQuantity> lateral;  ///< of lengths along the surface [1], > 0; of a picture the same input
};

/// Factors of all instruments; none: instruments state the truth, and the study is told of no factor.
struct Calibrations {
    InstrumentCalibration stylus, afm, tem;
    std::optional<StatedQuantity> force, displacement, contact_radius;  ///< of the machine of all loops [1], > 0
};

}  // namespace setae::simulation
