// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/imaging/frames.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::simulation {

/// A curve in a picture [px], positions as in imaging::FramePixels: x to the right, y downwards.
struct PixelCurve {
    Array1D x, y;
};

/// Rendering of the projection of a foil. Lengths in pixels; grey levels in units of the step between vacuum and
/// sample.
struct MicrographOptions {
    long width = 512, height = 512;
    double vacuum_level = 1.0, sample_level = 0.0;
    double noise = 0.5;       ///< standard deviation of a pixel: the picture's SNR is 1/noise
    double noise_blur = 0.0;  ///< blur of the noise by the camera: neighbouring pixels share noise
    double blur = 0.8;        ///< standard deviation of the lens's Gaussian
    /// amplitude of the Fresnel fringe at the edge, bright outside where positive (underfocus)
    double fringe_amplitude = 0.0;
    double fringe_width = 3.0;  ///< distance of the first bright line from the edge
    /// rise of the grey level across the picture, along a diagonal, with a parabola of half of that rise
    double drift = 0.0;
    double lattice_amplitude = 0.0;  ///< amplitude of fringes of atomic planes within the sample
    /// period and angle [rad]; patches of other angles, as of crystallites (Voronoi cells), about 60 px wide, differ by
    /// 0.5 rad
    double lattice_period = 6.0, lattice_angle = 0.6;
    double texture = 0.0;  ///< standard deviation of amorphous contrast within the sample, correlated over 2 px
    numerics::RandomKey key;
};

/// The picture of a sample with a given edge.
///
/// The sample lies below the curve (larger y). The curve begins at or before the left edge, ends at or beyond the right
/// one, may turn back (overhangs), but must not cross itself. Coverage of each pixel by the polygon is exact, so the
/// edge is at the curve; then blur, fringe, lattice, drift, noise:
///
///   I = vacuum + (sample − vacuum) B + fringe + (lattice + texture) B + drift + noise,   B: coverage blurred by a
///   Gaussian
///
/// The curve continues horizontally beyond its ends for the blur. Fringe, at the distance d = t fringe_width from the
/// curve, > 0 in vacuum:
///
///   fringe_amplitude sin(π t (2 + t²)/6) exp(−(t² − 1)²/4.5)
///
/// a bright line at t = 1, a dark one of 0.43 of it at 1.68, closer and fainter ones beyond, as of a partly coherent
/// Fresnel edge; odd, so that it does not move the position of steepest slope on average, and smooth enough for pixels
/// where fringe_width >= 3. Drift: drift (s + 2 s (1 − s)), s = (column/(width − 1) + row/(height − 1))/2. Equal keys
/// give equal bytes.
/// @throws InvalidArgument outside the domains, for a curve with fewer than two points, one that does not span the
/// picture or crosses itself. 2000² pixels with all of it: 0.4 s.
[[nodiscard]] imaging::FramePixels render_micrograph(const PixelCurve& curve, const MicrographOptions& options);

}  // namespace setae::simulation
