// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/topography/dilation.hpp"

namespace setae::topography {

/// Where a scan shows the true surface for certain.
struct Certainty {
    HeightMap reconstruction;  ///< eroded(image)
    /// 1 where the reconstruction is the surface, 0 where it is an upper bound; shape of the map.
    Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> certain;
    double share = 0.0;        ///< of certain points among defined ones
};

/// Points of the reconstruction that some position of the tip touches alone.
///
/// The tip at x touches r at x + u where r(x + u) − t(u) >= i(x) − tolerance. It touched the surface somewhere; where only
/// one point can be it, the surface is known there.
/// tolerance [m], >= 0: heights closer than this count as touched; unset: 1e-9 of the height range, for rounding. Positions
/// whose tip reaches over the window's end prove nothing, as the point touched may lie outside, unless the map is periodic.
/// @throws InvalidArgument as dilated, and for a negative tolerance.
/// Source: Villarrubia 1997, section 3.4.
[[nodiscard]] Certainty certainty_map(const HeightMap& image, const Tip& tip, const DilationOptions& options = {},
                                      std::optional<double> tolerance = {});

}  // namespace setae::topography
