// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "branch.hpp"

namespace setae::loops {

/// Changes while the force is held; empty where the record has no hold, or too few samples in it.
[[nodiscard]] std::optional<HoldGrowth> hold_growth(const LevelledLoop& record, const ContactSegments& contact,
                                                    const BranchAnalysis& loading, const LensAndCounterBody& bodies,
                                                    const AnalysisOptions& options);

}  // namespace setae::loops
