// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// A number by draws of everything it rests on, beside its linear propagation.
struct DrawnValue {
    double value = 0.0;           ///< at the inputs as stated
    double standard_error = 0.0;  ///< of the draws
    Interval interval;            ///< between their 2.5 and 97.5 %
    double linear_standard_error = 0.0;
    Interval linear_interval;
    bool parts = false;  ///< an end of the two intervals differs by more than a tenth of the linear one's width
};

/// W_int and what it predicts, by draws.
struct BalanceDraws {
    int count = 0;
    std::uint64_t seed = 0;
    std::optional<DrawnValue> work_of_adhesion;  ///< where it was fitted
    std::vector<DrawnValue> predictions;         ///< max(0, balance) of each line
};

/// Draws every direction of every input, the noise of every measured value and the scatter of the model; each draw has its
/// W with the weights of the fit, W + hᵀ(y − f(W)) with the draw's y and f, and predicts with it through the floor at 0.
/// Directions are normal, those
/// of rectangular inputs uniform.
///
/// pairs, fit: what was measured and the fit to it; or no pairs and W as given, with its inputs.
/// lines: balances to be predicted; one with a `departure` departs by effects of the scatter, too, those of its surface and
/// elastomer being the ones that pairs have.
/// Same numbers for a seed on any machine.
/// Source: JCGM 101:2008.
[[nodiscard]] BalanceDraws draw_balances(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                         const std::vector<PairPoint>& lines, int count, std::uint64_t seed);

}  // namespace setae::adhesion
