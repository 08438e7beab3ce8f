// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/numerics/random_numbers.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::simulation {

/// The curve that an instrument's drive adds to every scan of one session.
///
///   z(x) = rms √(2/Σ k^−2) Σ_{k=1}^{6} k^−1 cos(2π k x/longest_wavelength + φ_k),  φ_k from the session's key
///
/// x [m] counts from the start of the traverse, so that all scans of a session contain the same curve.
struct DriveArtefact {
    double rms = 0.0;                  ///< rms of the curve over its longest wavelength [m], >= 0; 0 is none
    double longest_wavelength = 1e-3;  ///< [m], > 0
    numerics::RandomKey session;
};

/// z(x) [m]. @throws InvalidArgument outside the domain above.
[[nodiscard]] double drive_artefact(const DriveArtefact& artefact, double position);

/// One scan with a stylus profilometer.
struct StylusOptions {
    topography::Tip tip = topography::SphereTip{5e-6};
    std::optional<double> tip_radius_standard_error;  ///< standard error [m], written into the metadata
    double length = 0.5e-3;                           ///< number of points times step [m]
    double step = 0.1e-6;                             ///< distance between points [m]
    double start_x = 0.0, start_y = 0.0;              ///< start of the scan on the surface [m]; it runs along x
    double noise_rms = 0.0;                           ///< rms of the white noise of each point [m]
    double tilt = 0.0;                                ///< slope of the scan's plane
    double bow = 0.0;                                 ///< height of the parabola, middle minus ends [m]
    DriveArtefact artefact;
    numerics::RandomKey key;            ///< key of the noise of this scan
    topography::DilationOptions touch;  ///< threads and range of the tip's contact
};

/// The record of the stylus.
///
///   z_i = i(start_x + x_i, start_y) + tilt x_i + bow (1 − (2x_i/ℓ − 1)²) + artefact(x_i) + noise_i,  x_i = i step
///
/// i: the surface dilated by the tip in two dimensions, read pointwise at the nearest grid point (waves shorter than
/// two steps are aliased as in an instrument), so the surface's pixels are best a whole fraction of the step. ℓ =
/// length − step. round(length/step) points. Noise i is a normal number of the key and i. Metadata: instrument type
/// "stylus" with the tip's radius.
/// @throws InvalidArgument for fewer than two points, a negative noise or step, a scan that extends beyond a surface
/// that is not periodic, and as topography::dilated.
[[nodiscard]] topography::LineScan stylus_scan(const topography::HeightMap& surface, const StylusOptions& options);

/// The record on a surface that is prepared for the tip once, for several scans: options.tip only gives the radius.
[[nodiscard]] topography::LineScan stylus_scan(const topography::Dilator& touched, const StylusOptions& options);

/// The record for given readings of the tip at each point [m].
/// @throws InvalidArgument for another number of readings than points.
[[nodiscard]] topography::LineScan recorded_scan(Array1D readings, const StylusOptions& options);

/// A scan of a smooth flat, with all contributions except the surface.
[[nodiscard]] topography::LineScan reference_scan(const StylusOptions& options);

}  // namespace setae::simulation
