// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/micrograph.hpp"

namespace setae::simulation {

/// A rough curve across a picture. Lengths in pixels.
struct RoughCurveOptions {
    long width = 1000, height = 1000;  ///< size of the picture
    double rms_height = 8.0;      ///< rms height of the Gaussian waves, exact over their period of 1.5 times the curve
    double hurst_exponent = 0.8;  ///< C1D(q) ∝ max(q, 2π/rolloff)^(−1−2H)
    double rolloff_wavelength = 1000.0;
    double cutoff_wavelength = 10.0;  ///< shorter waves are left out
    double tilt = 0.0;                ///< [rad] about the picture's middle, clockwise in the picture; |tilt| < 1
    int bulges = 0;                   ///< overhangs: a round cap on a narrower neck, two re-entrant stretches each
    double min_depth = 5.0, largest_depth = 10.0;  ///< depth by which a bulge overhangs its neck on either side
    numerics::RandomKey key;
};

/// Position at which a curve turns back: the innermost point of the pocket next to a bulge's neck, and the overhang of
/// the cap above it, along the curve's mean line.
struct Overhang {
    double x = 0.0, y = 0.0;
    double depth = 0.0;
};

/// A curve and its known properties.
struct RoughCurve {
    PixelCurve curve;  ///< about four points per pixel, from beyond the picture's left edge to beyond its right one
    std::vector<Overhang> overhangs;  ///< from left to right
};

/// Gaussian self-affine heights about the picture's middle, with bulges, rotated by the tilt.
///
/// A bulge: a circle of radius R that two fillets of radius r join to the level line, so that its neck is narrowest, 2
/// (R − depth), at the height r; depth as in the options, neck 2 × 6 … 9 px, r 5 … 8 px, each drawn uniformly. The
/// random heights are added at each x, which does not change depths along the mean line and cannot make the curve cross
/// itself. Equal keys give equal bytes.
/// @throws InvalidArgument for sizes below 16 pixels, heights or wavelengths that are not positive, cutoff >= rolloff,
/// a cutoff below 2 px, H outside (0, 1], a tilt beyond 1 rad, depths that are not 0 < least <= largest, or more bulges
/// than fit into the curve.
[[nodiscard]] RoughCurve rough_curve(const RoughCurveOptions& options);

}  // namespace setae::simulation
