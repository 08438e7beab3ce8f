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

/// A record whose force counts from its zero, and what is known of its errors.
struct LevelledLoop {
    const Loop& loop;
    const Baseline& noise;
    const Array2D& zero_modes;  ///< of ForceZero
};

/// The samples chosen, those with an undefined or zero contact radius left out.
[[nodiscard]] BranchData branch_data(const LevelledLoop& record, const Selection& selection,
                                     const AnalysisOptions& options);

/// Every fit of one branch; a fit that cannot be made carries its reason. elastic_modulus: E* that G of measured radii
/// is computed with, else the branch's own, which takes in what G gains with the speed of the edge.
/// @throws UndefinedDataError where no fit can be made at all.
[[nodiscard]] BranchAnalysis analyse_branch(const LevelledLoop& record, const Selection& selection,
                                            const LensAndCounterBody& bodies, const AnalysisOptions& options,
                                            const std::optional<Estimate>& elastic_modulus = {});

/// The branch's primary fit alone.
[[nodiscard]] JkrFit primary_fit(const BranchData& data, const LensAndCounterBody& bodies,
                                 const AnalysisOptions& options);

}  // namespace setae::loops
