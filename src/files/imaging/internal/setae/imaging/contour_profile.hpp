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
/// u: metres a pixel of the curve's length, a: metres a pixel across it. Of square pixels u = a is their size; of
/// others u is the curve's length in metres over that in pixels and u a the area of a pixel, standard errors times a:
/// right on average. Of a binary picture (edge_width 0) places are staircases: no response.
/// @throws InvalidArgument for sizes that are not positive.
[[nodiscard]] topography::TracedCurve traced_curve(const ContourSegment& segment, const PixelSize& pixel_size);

}  // namespace setae::imaging
