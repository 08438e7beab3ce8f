// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/synthesis/height_transform.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

/// The map with every height h replaced by h_rms g(h/h_rms), its mean subtracted.
///
/// The rms height is kept (in the ensemble), the spectrum is not: the autocorrelation becomes that of
/// TransformCorrelation. Undefined heights remain undefined. gaussian_rms_height: h_rms of the ensemble of the map [m].
/// @throws InvalidArgument for an rms height that is not positive.
[[nodiscard]] topography::HeightMap transformed_heights(const topography::HeightMap& map,
                                                        const HeightTransform& transform, double gaussian_rms_height);

/// A surface with another height distribution and the given spectrum.
struct NonGaussianSurface {
    topography::HeightMap map;
    double dropped_share = 0.0;  ///< of the variance of the parent; the relative error of the spectrum is similar, 0:
                                 ///< none
};

/// A periodic surface of zero mean with the height distribution of the transform and the spectrum C_iso.
///
/// A Gaussian parent is computed whose transformed heights have the autocorrelation of C_iso on the grid:
/// TransformCorrelation::parent inverts each of its values, and the transform of the result is the spectrum of the
/// parent. Not every autocorrelation has a Gaussian parent: negative modes are dropped and counted. Random numbers as
/// in random_surface: with the identity as transform the map is that of random_surface to rounding. Memory: about six
/// maps. O(n log n), four transforms; 2048² in 0.4 s on two cores.
/// @throws InvalidArgument as random_surface and TransformCorrelation.
/// Source: Grigoriu, Applied Non-Gaussian Processes (1995), section 3.1 (translation processes).
[[nodiscard]] NonGaussianSurface non_gaussian_surface(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                      const HeightTransform& transform,
                                                      const SurfaceOptions& options = {});

}  // namespace setae::synthesis
