// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"

namespace setae {

/// A warning: code, subject, size of the effect and action.
struct Alert {
    std::string code;     ///< from the catalogue of warnings, such as "TIP_CUTOFF"
    std::string subject;  ///< measurement, surface or loop concerned
    std::string message;  ///< cause and size of the effect
    std::string action;   ///< possible action of the user

    friend bool operator==(const Alert&, const Alert&) = default;
};

/// Range of wavevectors [1/m] that a number depends on.
struct Band {
    double lower = 0.0;
    double upper = 0.0;
};

/// A result of setae: value with unit, uncertainty, band and origin.
struct Quantity {
    std::string quantity;  ///< the field's term, snake_case, such as "rms_height"
    std::string symbol;    ///< such as "h_rms"
    Estimate estimate;     ///< in `unit`; NaN if undefined
    std::string unit;      ///< SI, such as "m", "J/m2", "1"
    std::optional<Band> band;
    std::optional<int> n;  ///< number of measurements, points or pairs used
    std::string source;    ///< formula and reference
    std::vector<Alert> alerts;
};

}  // namespace setae
