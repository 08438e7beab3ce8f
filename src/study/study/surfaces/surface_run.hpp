// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "running/run.hpp"

namespace setae::study {

/// All results of one surface as a step of a run: results in the store are not computed again.
/// @throws Cancelled where the run is.
[[nodiscard]] SurfaceWithMap analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options, Run& run,
                                             parallel::Threads threads, const Wanted& wanted = {});

/// The steps analyse_surface() will take.
[[nodiscard]] std::vector<PlannedStep> planned_steps(const SurfaceInput& input, const SurfaceAnalysisOptions& options,
                                                     const Run& run);

}  // namespace setae::study
