// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/numerics/random_numbers.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// Distribution of the distances between the points of a contour.
enum class ContourSteps {
    regular,  ///< constant
    uniform,  ///< uniform
    gamma,    ///< gamma distribution, the sum of ν squared normal numbers: many short, few long ones
};

/// Largest rms of the distance divided by its mean.
[[nodiscard]] double widest_spread(ContourSteps steps);

/// One traced contour of a foil in a transmission electron microscope.
struct FoilContourOptions {
    double thickness = 0.0;  ///< thickness of the foil along the beam (y) [m]; 0: a line through the surface
    double start_x = 0.0, start_y = 0.0;  ///< position of the foil on the surface [m]
    double length = 100e-9;               ///< length of the contour along x [m]
    double step = 2e-10;                  ///< mean distance of points along x [m]
    ContourSteps steps = ContourSteps::gamma;
    double step_spread = 0.5;  ///< rms of the distance divided by its mean: uniform <= 1/√3, gamma √(2/ν), ν rounded
    double blur = 0.0;         ///< rms radius of the image's blur [m]
    double trace_noise_rms = 0.0;      ///< rms deviation of the manual trace in height [m]
    double trace_noise_length = 1e-9;  ///< correlation length of that deviation [m]
    double reentrant_share = 0.0;      ///< share of points traced backwards, 0 … 0.5
    Index reentrant_points = 4;        ///< number of points in one such section
    numerics::RandomKey key;
};

/// The traced contour, before topography::clean_contour.
///
/// Heights: the silhouette over the foil's thickness, blurred, linear between its grid points, plus the deviation of
/// the manual trace
///
///   h(x) = ∫ s(x') exp(−(x − x')²/(2 blur²)) dx'/(√(2π) blur) + n(x),  ⟨n(x) n(x + d)⟩ = rms² exp(−d²/(2 length²))
///
/// which is the half level of an image blurred by a Gaussian to first order in the slope. Points run from 0 to about
/// `length` [m] in random steps. Re-entrant sections: at random positions runs of points turn back to x → x_p − (x −
/// x_p)/2, with x_p of the preceding point; clean_contour removes them and keeps all other points. Metadata: instrument
/// type "tem", the thickness as attribute "foil_thickness".
/// @throws InvalidArgument outside the domains above, for a step wider than the length or a contour that extends beyond
/// a surface that is not periodic; UndefinedDataError where the silhouette is undefined.
[[nodiscard]] topography::Profile projected_contour(const topography::HeightMap& surface,
                                                    const FoilContourOptions& options);

}  // namespace setae::simulation
