// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/loops/energy_budget.hpp"
#include "setae/loops/range_scan.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

/// A loop that was analysed, as its figures need it.
struct DrawnLoop {
    std::string name;  ///< stem of the files, and in titles
    const loops::LoopAnalysis& analysis;
    const loops::LensAndCounterBody& bodies;
    const loops::AnalysisOptions& options;
};

/// The figures of one loop: "loop" (force, contact radius and energy release rate, with the fits) and "residuals" (of
/// every fit).
///
/// command: command that makes them again, for the files' headers.
[[nodiscard]] std::vector<StudyFigure> loop_figures(const DrawnLoop& loop, const std::string& command,
                                                    FigureWidth width = FigureWidth::double_column);

/// A loop's name with how its fit depends on the range.
struct NamedScan {
    std::string name;
    loops::RangeScan scan;
};

/// E* and W of loading against where the fit begins and ends, and in their own plane with the 95 % ellipses of the
/// fits: "ranges".
[[nodiscard]] StudyFigure range_figure(const std::vector<NamedScan>& scans, const std::string& command,
                                       FigureWidth width = FigureWidth::double_column);

/// Energy budget of a loop, sample by sample, and against the contact area: "energy".
[[nodiscard]] StudyFigure course_figure(const DrawnLoop& loop, const loops::EnergyCourse& course,
                                        const std::string& command);

/// A loop's loss and the area it was lost on.
struct NamedLoss {
    std::string name;
    Estimate loss;            ///< [J]
    double true_area = 0.0;   ///< r π a_max² [m²]
    double ideal_loss = 0.0;  ///< loss of a smooth sphere in this testing machine [J]
};

/// E_loss against true area at the largest preload, with the line through the origin (true-area loss, Eq. 10), for all
/// loops: "losses".
[[nodiscard]] StudyFigure loss_figure(const std::vector<NamedLoss>& losses, const std::string& command);

}  // namespace setae::study_figures
