// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/processing/processed.hpp"

namespace setae::processing {

/// The seam of a map or a line that repeats itself: where the last row meets the first.
struct Seam {
    double height_step = 0.0;  ///< rms over the points of the seam [m]; of a map the larger one of both directions
    double usual_step = 0.0;   ///< rms step between neighbouring rows in that direction [m]
    bool closed = true;        ///< whether the heights go on across the seam as they do inside
};

/// The seam of a measurement.
///
///   closed: rms step <= 2 usual rms step, and |mean step| <= 3 usual rms of the mean step of two neighbouring rows,
///   in every direction
///
/// The first limit finds ends that differ, the second a tilt that lies below a roughness from point to point. Surfaces
/// that repeat themselves meet both; of a map with fewer than ten independent points per row chance may say otherwise.
/// Undefined heights do not count. A profile has no seam: closed.
[[nodiscard]] Seam seam_of(const topography::Measurement& measurement);

/// Heights that go to their mean at the edges, so that a map or a line can repeat itself.
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
