// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Samples of a record chosen for a fit.
struct Selection {
    std::string name;
    std::vector<Index> samples;
};

/// Loading of a contact without the partial releases in it, so many samples dropped at its start.
[[nodiscard]] Selection loading_selection(const Loop& loop, const Segments& segments, const ContactSegments& contact,
                                          Index dropped);

/// All samples of a stretch.
[[nodiscard]] Selection range_selection(const IndexRange& range, std::string name);

/// A record with its force relative to its zero, and its known errors.
struct LevelledLoop {
    const Loop& loop;
    const Baseline& noise;
    const Array2D& zero_modes;  ///< of ForceZero
};

/// The samples chosen, those with an undefined or zero contact radius left out.
[[nodiscard]] BranchData branch_data(const LevelledLoop& record, const Selection& selection,
                                     const AnalysisOptions& options);

/// Every fit of one branch; a fit that is not possible has its reason. elastic_modulus: E* for G of measured radii,
/// else that of the branch, which includes the increase of G with the speed of the edge.
/// @throws UndefinedDataError where no fit is possible.
[[nodiscard]] BranchAnalysis analyse_branch(const LevelledLoop& record, const Selection& selection,
                                            const LensAndCounterBody& bodies, const AnalysisOptions& options,
                                            const std::optional<Estimate>& elastic_modulus = {});

/// Only the branch's primary fit.
[[nodiscard]] JkrFit primary_fit(const BranchData& data, const LensAndCounterBody& bodies,
                                 const AnalysisOptions& options);

}  // namespace setae::loops
