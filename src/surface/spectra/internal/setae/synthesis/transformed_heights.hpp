// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/synthesis/height_transform.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

/// The map with every height h replaced by h_rms g(h/h_rms), its mean subtracted.
///
/// Rms height stays (in the ensemble), the spectrum does not: its autocorrelation becomes that of TransformCorrelation.
/// Undefined heights stay undefined. gaussian_rms_height: h_rms of the ensemble the map is from [m].
/// @throws InvalidArgument for an rms height that is not positive.
[[nodiscard]] topography::HeightMap transformed_heights(const topography::HeightMap& map,
                                                        const HeightTransform& transform, double gaussian_rms_height);

/// A surface with another height distribution and the spectrum asked for.
struct NonGaussianSurface {
    topography::HeightMap map;
    double dropped_share = 0.0;  ///< of the parent's variance; the spectrum is off by about as much, 0: none
};

/// A periodic surface of zero mean whose heights are distributed as the transform says and whose spectrum is C_iso.
///
/// A Gaussian parent is made whose heights, transformed, have the autocorrelation of C_iso on the grid: each value of
/// it goes back through TransformCorrelation::parent, and its transform is the parent's spectrum. Not every
/// autocorrelation has a Gaussian parent: negative modes are dropped and counted. Random numbers as in random_surface:
/// with the identity as transform the map is that of random_surface to rounding. Memory: about six maps. O(n log n),
/// four transforms; 2048² in 0.4 s on two cores.
/// @throws InvalidArgument as random_surface and TransformCorrelation do.
/// Source: Grigoriu, Applied Non-Gaussian Processes (1995), section 3.1 (translation processes).
[[nodiscard]] NonGaussianSurface non_gaussian_surface(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                      const HeightTransform& transform,
                                                      const SurfaceOptions& options = {});

}  // namespace setae::synthesis
