// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "branch.hpp"

namespace setae::loops {

/// A record ready for analysis.
struct PreparedRecord {
    Loop deflected;  ///< the machine's own deflection and the displacement's drift taken off
    Loop level;      ///< the drift of force, too
    Segments segments;
    DriftModel drift = DriftModel::between_baselines;  ///< of the energies
};

/// A branch without the samples that no fit uses.
[[nodiscard]] Selection without_ignored(Selection selection, const Segments& segments);

/// Everything about one touch.
/// @throws UndefinedDataError where its loading has too few samples.
[[nodiscard]] ContactAnalysis analyse_contact(const PreparedRecord& record, Index contact,
                                              const LensAndCounterBody& bodies, const AnalysisOptions& options);

}  // namespace setae::loops
