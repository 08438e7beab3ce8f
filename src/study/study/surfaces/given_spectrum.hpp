// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// The self-affine spectrum with three published moments as the spectrum of a surface; their standard errors as its
/// spread. @throws InvalidArgument for moments of no such spectrum.
void take_moments(SurfaceResult& surface, const PublishedMoments& moments, const SurfaceAnalysisOptions& options);

/// A table q, C1D as the spectrum of the surface that names it.
/// @throws what reading it throws.
void take_power_spectrum(SurfaceResult& surface, const SurfaceInput& input, const SurfaceAnalysisOptions& options);

}  // namespace setae::study
