// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// Force of the pair's records minus that of its predicted loop at the same displacement, counted from the contact
/// point of each record, rms over loops and samples in contact, branch by branch. Empty without a record that has a
/// displacement.
[[nodiscard]] std::optional<LoopResiduals> loop_residuals(const StudyResult& result, const PairHysteresis& pair);

}  // namespace setae::study
