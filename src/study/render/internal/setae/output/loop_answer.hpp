// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/loops/analysis.hpp"
#include "setae/loops/force_curve_summary.hpp"
#include "setae/study/force_map.hpp"

/// Result of an experiment in one sentence: E*, W, pull-off, loss, numbers by format_uncertain(); "–" and the reason
/// for missing values and for fits that did not converge.
namespace setae::output {

/// E* and W of loading, with how far W runs with the beginning of the range, the pull-off, the loss.
[[nodiscard]] std::string answer(const loops::LoopAnalysis& loop);
[[nodiscard]] std::string answer(const loops::ForceCurveSummary& curve);
/// Medians of the curves ± half the range of their middle 68 %, and the number of curves without a result, with the
/// reason.
[[nodiscard]] std::string answer(const study::ForceMap& map);

}  // namespace setae::output
