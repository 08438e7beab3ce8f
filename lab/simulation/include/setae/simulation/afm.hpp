// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/numerics/random_numbers.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::simulation {

/// One map with an atomic force microscope.
struct AfmOptions {
    topography::Tip tip = topography::SphereTip{10e-9};
    std::optional<double> tip_radius_standard_error;  ///< standard error [m], written into the metadata
    Index nx = 512, ny = 512;                         ///< points along x, the fast axis, and y
    double size = 1e-6;                               ///< extent along x [m]; the pixels are square
    double start_x = 0.0, start_y = 0.0;              ///< position of the map on the surface [m]
    double noise_rms = 0.0;                           ///< rms of the white noise of each point [m]
    double line_offset_rms = 0.0;                     ///< rms of independent shifts of whole lines [m]
    double line_drift_rms = 0.0;                      ///< rms of one step of a random walk from line to line [m]
    double tilt_x = 0.0, tilt_y = 0.0;                ///< slopes of the map's plane
    double bow = 0.0;           ///< height of the scanner's parabola along x, middle minus ends [m]
    double feedback_lag = 0.0;  ///< distance over which the tip follows a step to 1/e [m]
    numerics::RandomKey key;
    topography::DilationOptions touch;  ///< threads and range of the tip's contact
};

/// The record of the microscope.
///
///   z_ij = lag[i_j](x_i) + tilt_x x_i + tilt_y y_j + bow (1 − (2x_i/ℓ − 1)²) + offset_j + Σ_{k<=j} drift_k + noise_ij
///
/// i: the surface dilated by the tip in two dimensions, read pointwise at the nearest grid point. lag[u]: solution of λ
/// dz/dx + z = u(x) along the fast axis, with u linear between points, z = u at the first point of each line; λ the
/// feedback lag. ℓ = size (nx − 1)/nx. Drift starts at zero in the first line. Metadata: instrument type "afm" with the
/// tip's radius.
/// @throws InvalidArgument for fewer than two points per direction, a size that is not positive, a negative rms or lag,
/// a map that extends beyond a surface that is not periodic, and as topography::dilated.
[[nodiscard]] topography::HeightMap afm_map(const topography::HeightMap& surface, const AfmOptions& options);

/// The record on a surface that is prepared for the tip once, for several maps: options.tip only gives the radius.
[[nodiscard]] topography::HeightMap afm_map(const topography::Dilator& touched, const AfmOptions& options);

/// The record for given readings of the tip at each pixel [m].
/// @throws InvalidArgument for another number of readings than pixels.
[[nodiscard]] topography::HeightMap recorded_map(Array2D readings, const AfmOptions& options);

}  // namespace setae::simulation
