// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// A number by draws of all its inputs.
struct DrawnValue {
    double value = 0.0;           ///< value at the stated inputs
    double standard_error = 0.0;  ///< standard deviation of the draws
    Interval interval;            ///< interval between the 2.5 and 97.5 % points
};

/// W_int and its predictions, by draws.
struct BalanceDraws {
    int count = 0;
    std::uint64_t seed = 0;
    std::optional<DrawnValue> work_of_adhesion;  ///< W_int, where it is fitted
    std::vector<DrawnValue> predictions;         ///< max(0, balance) of each line
};

/// @throws InvalidArgument for fewer than two draws.
[[nodiscard]] DrawnValue drawn_value(double value, std::vector<double> draws);

/// Draws every direction of every input of W and of the lines, and the scatter of the lines, and predicts through the
/// floor at 0. Directions are normal, those of rectangular inputs uniform. For a fitted W see WorkPosterior::draw().
///
/// scatter: scatter of the model. A seed gives equal numbers on all platforms. Source: JCGM 101:2008.
[[nodiscard]] BalanceDraws draw_balances(const TracedValue& work_of_adhesion, const ModelScatter& scatter,
                                         const std::vector<PairPoint>& lines, int count, std::uint64_t seed);

}  // namespace setae::adhesion
