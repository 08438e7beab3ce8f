// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/experiment/range_scan.hpp"
#include "setae/gallery/study_figures.hpp"

namespace setae::gallery {

/// A loop that was analysed, as its figures need it.
struct DrawnLoop {
    std::string name;  ///< stem of the files, and in titles
    const experiment::LoopAnalysis& analysis;
    const experiment::LensAndCounterBody& bodies;
    const experiment::AnalysisOptions& options;
};

/// The figures of one loop: "loop" (force, contact radius and energy release rate, with the fits) and "residuals" (of every fit).
///
/// command: what makes them again, for the files' headers.
[[nodiscard]] std::vector<StudyFigure> loop_figures(const DrawnLoop& loop, const std::string& command);

/// A loop's name with how its fit depends on the range.
struct NamedScan {
    std::string name;
    experiment::RangeScan scan;
};

/// E* and W of loading against where the fit begins and ends, and in their own plane with the 95 % ellipses of the fits: "ranges".
[[nodiscard]] StudyFigure range_figure(const std::vector<NamedScan>& scans, const std::string& command);

}  // namespace setae::gallery
