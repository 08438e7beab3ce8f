// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "branch.hpp"
#include "records/force_zero.hpp"

namespace setae::loops {

/// A record ready for analysis.
struct PreparedRecord {
    Loop deflected;  ///< deflection of the testing machine and drift of the displacement subtracted
    Loop level;      ///< the zero of force and its drift, too
    Segments segments;
    ForceZero zero;  ///< zero that was subtracted from the force

    [[nodiscard]] LevelledLoop levelled() const { return {level, segments.before, zero.modes}; }
};

/// A branch without the samples that no fit uses.
[[nodiscard]] Selection without_ignored(Selection selection, const Segments& segments);

/// A record with its faults removed as requested by the options. `known`: segments to keep, in which baselines are
/// measured again; else they are found.
/// @throws as find_segments.
[[nodiscard]] PreparedRecord prepared(const Loop& recorded, const RecordFaults& faults, const AnalysisOptions& options,
                                      const Segments* known = nullptr);

/// Analysis of one contact. `decided`: an analysis whose pinned section is kept; else it is determined.
/// @throws UndefinedDataError where its loading has too few samples.
[[nodiscard]] ContactAnalysis analyse_contact(const PreparedRecord& record, Index contact,
                                              const LensAndCounterBody& bodies, const AnalysisOptions& options,
                                              const ContactAnalysis* decided = nullptr);

}  // namespace setae::loops
