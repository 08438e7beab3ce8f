// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/analysis.hpp"

namespace setae::loops {

enum class LoopBranch { loading, unloading };

/// The samples that the fits of a branch of the first contact rest on.
struct BranchSamples {
    BranchData data;  ///< force counted from its zero
    Array1D time;     ///< [s]; empty where not recorded
};

/// @throws UndefinedDataError with the analysis' reason where it has no such branch.
[[nodiscard]] BranchSamples branch_samples(const LoopAnalysis& analysis, LoopBranch branch,
                                           const AnalysisOptions& options);

}  // namespace setae::loops
