// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/topography/dilation.hpp"
#include "setae/topography/mask.hpp"

namespace setae::topography {

/// Where a scan shows the true surface for certain.
struct Certainty {
    HeightMap reconstruction;  ///< eroded(image)
    Mask certain;              ///< 1 where the reconstruction is the surface, 0 where it is an upper bound
    double share = 0.0;        ///< of certain points among defined ones
};

/// Points of the reconstruction that some position of the tip touches alone.
///
/// The tip at x touched the surface at a point x + u with h = i(x) + t(u) = r(x + u): where only one point has r(x + u)
/// >= i(x) + t(u) − tolerance, the surface is known there. Beyond the window's ends and at undefined heights the
/// surface may be as high as the image around lets it, at most as high as the highest point seen: what the tip may have
/// touched there counts as touched. Undefined heights stay undefined and are not certain, whatever
/// options.keep_undefined. tolerance [m], >= 0: heights closer than this count as touched; unset: 1e-9 of the height
/// range, for rounding.
/// @throws InvalidArgument as dilated, and for a negative tolerance.
/// Source: Villarrubia 1997, section 3.4.
[[nodiscard]] Certainty certainty_map(const HeightMap& image, const Tip& tip, const DilationOptions& options = {},
                                      std::optional<double> tolerance = {});

}  // namespace setae::topography
