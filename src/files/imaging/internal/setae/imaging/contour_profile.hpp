// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/imaging/contour_trace.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/topography/traced_curve.hpp"

namespace setae::imaging {

/// A traced segment in metres, y upwards.
///
///   blur = w u, smoothing_length = ℓ u, step = u, noise_density = N u a²
///
/// u: metres per pixel along the curve, a: metres per pixel across it. For square pixels u = a is their size; for
/// others u is the length of the curve in metres over that in pixels, u a the area of a pixel, and standard errors are
/// multiplied by a: correct on average. The places of a binary picture (edge_width 0) are staircases: no response.
/// @throws InvalidArgument for sizes that are not positive.
[[nodiscard]] topography::TracedCurve traced_curve(const ContourSegment& segment, const PixelSize& pixel_size);

}  // namespace setae::imaging
