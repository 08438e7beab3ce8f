// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/estimate.hpp"

namespace setae::simulation {

/// A quantity of a data set: what it is, and what the study is told of it.
struct StatedQuantity {
    double value = 0.0;   ///< true, SI
    Estimate told;        ///< what the study is told, SI
    std::string unit{};   ///< SI: "m"; empty for factors
    std::string input{};  ///< its name in the study's [inputs]; empty where it is told without one
};

}  // namespace setae::simulation
