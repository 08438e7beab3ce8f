// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// Fills `combined` and `average` of a surface from its measurements: mean over measurements, bootstrap, moved tips.
/// @throws UndefinedDataError where no measurement could be analysed.
void estimate_by_average(SurfaceResult& surface, const SurfaceAnalysisOptions& options, parallel::Threads threads);

}  // namespace setae::study
