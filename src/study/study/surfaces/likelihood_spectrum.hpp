// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// Fills `likelihood` of a surface from all its measurements at once and makes it the spectrum used.
///
/// prepared[i] belongs to surface.measurements[i], which has its trend and reliable band; it is empty for failed ones.
/// @throws what spectral_fit::likelihood_spectrum throws; the surface is unchanged then.
void estimate_by_likelihood(SurfaceResult& surface, std::vector<PreparedMeasurement> prepared,
                            const SurfaceAnalysisOptions& options, parallel::Threads threads);

}  // namespace setae::study
