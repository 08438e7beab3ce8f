// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"

namespace setae {

/// Something the reader of a number must know: which alert, about what, how large its effect, what to do.
struct Alert {
    std::string code;     ///< from the alert catalogue, such as "TIP_CUTOFF"
    std::string subject;  ///< the measurement, surface or loop it speaks of
    std::string message;  ///< cause and size of the effect
    std::string action;   ///< what the user can do

    friend bool operator==(const Alert&, const Alert&) = default;
};

/// Range of wavevectors [1/m] a number rests on.
struct Band {
    double lower = 0.0;
    double upper = 0.0;
};

/// A number that leaves setae: never without unit, and with what is known of its uncertainty, band and origin.
struct Quantity {
    std::string quantity;  ///< the field's term, snake_case, such as "rms_height"
    std::string symbol;    ///< such as "h_rms"
    Estimate estimate;     ///< in `unit`; NaN where undefined
    std::string unit;      ///< SI, such as "m", "J/m2", "1"
    std::optional<Band> band;
    std::optional<int> n;  ///< measurements, points or pairs it rests on
    std::string source;    ///< formula and where it comes from
    std::vector<Alert> alerts;
};

}  // namespace setae
