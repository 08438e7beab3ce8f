// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "setae/study_figures/study_figures.hpp"

namespace setae::report {

/// Text of a page on its figures, in addition to their captions.
struct FigurePage {
    std::string study;                           ///< path of the study file, for the commands
    std::map<std::string, std::string> remarks;  ///< HTML below the caption, by StudyFigure::identifier
    /// Largest number of figures "spectra:NAME" or "loop:NAME", by the part before the colon.
    std::map<std::string, std::size_t, std::less<>> of_a_kind;
};

/// Figures as HTML: report.js draws them from their JSON, when they become visible or are unfolded.
struct FigureParts {
    std::string carrying;  ///< that carry the verdict, open: 4, prediction and 1; where none of them can be drawn, the
                           ///< first that can
    std::string way_back;  ///< retraction and losses, folded
    std::string others;    ///< folded, then the reasons of those that cannot be drawn
};

/// Every figure with caption, buttons, data and the command that makes it again, as part "figure-NAME": "figure-4",
/// "figure-prediction".
[[nodiscard]] FigureParts figures_html(const std::vector<study_figures::StudyFigure>& figures, const FigurePage& page);

}  // namespace setae::report
