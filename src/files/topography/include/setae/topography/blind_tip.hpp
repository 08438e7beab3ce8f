// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tip.hpp"

namespace setae::topography {

/// What a blind estimate assumes of the tip.
struct BlindTipOptions {
    Index points_x = 21, points_y = 21;  ///< extent of the estimate in pixels of the map, odd
    double noise_threshold = 0.0;        ///< [m], >= 0: the image must demand more than this to sharpen the tip
    int rounds = 100;                    ///< at most so many sweeps over the image, > 0
    parallel::Threads threads;
};

/// A bound of the tip from its own scan.
struct BlindTip {
    ArrayTip tip;            ///< no higher above its apex than the true tip, within the extent
    bool converged = false;  ///< the last sweep changed nothing
    int rounds = 0;          ///< sweeps done
};

/// The bluntest tip that could have made the image.
///
/// Where the tip at x touched the surface at x + u, the surface is i(x) + t(u) high, which no other position passes
/// through: i(x + u) >= i(x) + t(u) and t(v) >= i(x) + t(u) − i(x + u − v) for all v. Which u it was is unknown, so
/// from t = 0
///
///   t(v) <- max[t(v), min_u {i(x) + t(u) − i(x + u − v)} − ε]  over u with i(x + u) >= i(x) + t(u) − ε
///
/// first from the image's local peaks, then from the points where opening the image by the tip (eroding, then dilating)
/// lowers it by more than ε, until nothing changes; ε: the threshold plus 1e-12 of the height range. Points nearer to
/// the window's end (unless periodic) or to an undefined height than the extent are left out. The estimate is never
/// above the true tip if that touches within the extent and ε is at least twice the noise's largest deviation; it
/// equals the tip where the surface has features sharper than it. Same bytes for any number of threads.
/// @throws InvalidArgument for extents that are even or not positive, a map too small to hold a point farther from its
/// ends than the extent, a negative threshold or no rounds; UndefinedDataError where undefined heights leave no such
/// point. Source: Villarrubia 1997, section 4 and appendix.
[[nodiscard]] BlindTip blind_tip(const HeightMap& image, const BlindTipOptions& options = {});

}  // namespace setae::topography
