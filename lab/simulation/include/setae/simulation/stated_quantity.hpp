// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/estimate.hpp"

namespace setae::simulation {

/// A quantity of a data set: its true value, and its value in the study.
struct StatedQuantity {
    double value = 0.0;     ///< true value, SI
    Estimate stated_value;  ///< value in the study, SI
    std::string unit{};     ///< SI: "m"; empty for factors
    std::string input{};    ///< name in the study's [inputs]; empty without a name
};

}  // namespace setae::simulation
