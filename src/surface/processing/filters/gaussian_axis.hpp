// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Gaussian sums along one direction at a cost that does not depend on the width.
///
///   K_ij = exp(−(i − j)²/(2 s²)) up to a factor, s: deviation in pixels
///
/// A wide Gaussian is the product of two of deviation s/√2 through coarse points s/2 apart: inputs are distributed to
/// coarse points, outputs are gathered from them. The sum over coarse points differs from the integral by 2 exp(−2π²) =
/// 5e-9; both Gaussians end 4 s from their centre, 5.66 of their deviations, beyond which 1.5e-8 of a Gaussian is left.
/// A narrow one is summed directly, out to 5.66 s. Coordinates are in units of s.
struct GaussianAxis {
    /// Powers of coordinates up to `orders` are tabulated; a deviation of 0 is the identity.
    GaussianAxis(Index points, double deviation, bool periodic, Index orders);

    /// The coarse point with a number; −1 if there is none.
    [[nodiscard]] Index place(Index number) const;

    Index points;
    bool periodic;
    bool direct = false;  ///< coarse points are the points
    Index coarse = 0;     ///< coarse points
    Index taps = 0;       ///< coarse points used by an output
    Index shares = 0;     ///< coarse points that an input contributes to; 0 if direct

    std::vector<Index> first_share;  ///< number of the first coarse point of an input
    std::vector<Array2D> share;      ///< [m](input, s): weight times ((x_input − X_s)/s)^m
    std::vector<Index> first_tap;    ///< number of the first coarse point of an output
    std::vector<Array2D> gather;     ///< [q](output, t): weight times ((X_t − X_reference)/s)^q
    Array1D coordinate;              ///< of an output relative to its reference, the coarse point below it
};

}  // namespace setae::processing
