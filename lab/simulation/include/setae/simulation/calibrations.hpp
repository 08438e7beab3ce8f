// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/simulation/stated_quantity.hpp"

namespace setae::simulation {

/// Calibration factors of one instrument, for all its measurements on all surfaces: true length = factor × stated
/// length.
struct InstrumentCalibration {
    std::optional<StatedQuantity> height;  ///< factor of heights [1], > 0
    /// factor of lengths along the surface [1], > 0; for a picture the same input
    std::optional<StatedQuantity> lateral;
};

/// Calibration factors of all instruments; without them, stated lengths are true and the study contains no factor.
struct Calibrations {
    InstrumentCalibration stylus, afm, tem;
    /// factors of the testing machine of all loops [1], > 0
    std::optional<StatedQuantity> force, displacement, contact_radius;
};

}  // namespace setae::simulation
