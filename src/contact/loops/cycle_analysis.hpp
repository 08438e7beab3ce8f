// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact_analysis.hpp"

namespace setae::loops {

/// One loading and unloading of a contact with a known analysis.
[[nodiscard]] CycleAnalysis analyse_cycle(const PreparedRecord& record, Index cycle, const ContactAnalysis& contact,
                                          const LensAndCounterBody& bodies, const AnalysisOptions& options);

}  // namespace setae::loops
