// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/processing/processed.hpp"

namespace setae::processing {

/// The seam of a periodic map or line, between its last and its first row.
struct Seam {
    double height_step = 0.0;  ///< rms over the points of the seam [m]; for a map the larger one of both directions
    double usual_step = 0.0;   ///< rms step between neighbouring rows in that direction [m]
    bool closed = true;        ///< whether the heights continue across the seam as inside
};

/// The seam of a measurement.
///
///   closed: rms step <= 2 usual rms step, and |mean step| <= 3 usual rms of the mean step of two neighbouring rows,
///   in every direction
///
/// The first limit detects different ends, the second a tilt below a point-to-point roughness. Periodic surfaces
/// satisfy both; for a map with fewer than ten independent points per row the result may differ by chance. Undefined
/// heights are ignored. A profile has no seam: closed.
[[nodiscard]] Seam seam_of(const topography::Measurement& measurement);

/// Tapers heights to their mean at the edges, so a map or a line becomes periodic.
///
///   h -> m + (h − m) w(x) w(y),  w = sin²(π (i + 1/2)/(2 n share)) within the share of the points at either edge, else
///   1
///
/// m: mean height.  share: of the extent at each edge, above 0, up to 0.5.  The result is periodic. Records rms height
/// step at the seam before, share of the area that was changed. The name in the record is "window_edges".
/// @throws InvalidArgument for a profile, and a share outside its domain.
/// Source: tapered cosine window, Tukey 1967; Harris, Proc. IEEE 66 (1978) 51.
[[nodiscard]] Processed windowed(topography::Measurement measurement, double share = 0.1);

}  // namespace setae::processing
