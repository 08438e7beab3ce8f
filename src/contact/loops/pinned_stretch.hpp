// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Samples after the last loading in which the contact edge does not move: the contact unloads like a flat punch, G
/// increases from one W to the other, and no JKR curve describes it.
///
/// The edge retracts permanently after the last sample whose contact radius is within four standard deviations of the
/// noise of the largest; noisier radii are averaged over their neighbours first. Where the radius was not measured, it
/// retracts after the last sample whose force exceeds that of a flat punch of the largest radius by less than four
/// standard deviations, and than 1 % of the unloaded force, 5 % where the error of W makes the largest radius
/// uncertain. Empty without a retraction, for a section of fewer than two samples, or where fewer than ten samples of
/// the branch would remain.
[[nodiscard]] std::optional<IndexRange> pinned_stretch(const Loop& loop, const Segments& segments,
                                                       const ContactSegments& contact, const ContactAnalysis& analysis,
                                                       const LensAndCounterBody& bodies,
                                                       const AnalysisOptions& options);

}  // namespace setae::loops
