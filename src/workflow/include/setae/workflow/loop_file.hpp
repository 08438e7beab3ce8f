// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/experiment/analysis.hpp"

namespace setae::workflow {

/// Reads a loop, through a mapping where one is given, and analyses it.
/// @throws what reading and experiment::analyse throw; every message names the file.
[[nodiscard]] experiment::LoopAnalysis analyse_loop_file(const std::string& path, const std::optional<std::string>& mapping_path,
                                                         const experiment::LensAndCounterBody& bodies,
                                                         const experiment::AnalysisOptions& options = {});

}  // namespace setae::workflow
