// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tip.hpp"

namespace setae::topography {

/// What a blind estimate assumes of the tip.
struct BlindTipOptions {
    Index points_x = 21, points_y = 21;  ///< extent of the estimate in pixels of the map, odd
    double noise_threshold = 0.0;        ///< [m], >= 0: features must contradict a tip by more than this to sharpen it
    int rounds = 100;                    ///< at most so many sweeps over the image
    parallel::Threads threads;
};

/// An upper bound of the tip from its own scan.
struct BlindTip {
    ArrayTip tip;            ///< the bluntest tip the image allows: never blunter images than its own peaks
    bool converged = false;  ///< the last sweep changed nothing
    int rounds = 0;          ///< sweeps done
};

/// The bluntest tip that could have made the image.
///
/// Every point of an image i = dilated(h) was touched by some point d of the tip, so its neighbourhood holds the whole tip
/// hung up at d. With p = −t (p <= 0, p(0) = 0) the estimate shrinks from a flat plate by
///
///   p(v) <- min_x max(p(v), ...) : min over image points x of max over d with i(x) − i(x − d) <= −p(d) + threshold of
///           min[p(v), i(x + v − d) − i(x) + p(d)] + threshold
///
/// until nothing changes. Points within the tip's extent of the window's end, or with undefined heights there, are left out.
/// The result bounds the true tip from below in t (it is never sharper) where the threshold exceeds the noise; it equals the
/// tip where the surface has features sharper than it.
/// @throws InvalidArgument for even or non-positive extents, an extent larger than the map, a negative threshold.
/// Source: Villarrubia 1997, section 4 and appendix.
[[nodiscard]] BlindTip blind_tip(const HeightMap& image, const BlindTipOptions& options = {});

}  // namespace setae::topography
