// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "straight_front.hpp"

namespace pinning_survey {

/// A straight front on a self-affine surface, lengths in points: shortest wave 8, longest 8 times the band, E* = W = 1.
struct Case {
    double energy_share = 0.0;  ///< U_el/(A W)
    setae::Index way = 0, width = 0;
    double spring_length = 0.0;  ///< π/q_κ of the spring that drives the front; 0: the width
    double band = 4.0;           ///< longest over shortest wave
    double hurst_exponent = 0.8;
    std::uint64_t seed = 1;
};

struct Result {
    double pinning_coefficient = 0.0;         ///< k
    double approach = 0.0, retraction = 0.0;  ///< (W_appr − W)/U, (W_ret − W)/U
    double larkin_lengths = 0.0;              ///< π/q_κ over the Larkin length
    bool converged = false;
};

Result run(const Case& which, double step = 0.5);

/// The same surface in two bands of √band each: a front through all its waves at once, and two after each other. The
/// works of the finer band are those that the coarser one has on approach and on retraction.
struct BandsResult {
    Result together, apart;
    double fine_share = 0.0;  ///< of U_el in the finer band
};
BandsResult run_in_bands(const Case& which, double step = 0.5);

}  // namespace pinning_survey
