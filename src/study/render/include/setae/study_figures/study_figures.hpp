// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "setae/figures/figure.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study_figures {

/// A figure of a study, or why it cannot be drawn.
struct StudyFigure {
    std::string identifier;  ///< what `setae plot --figure` calls it: "1", "2", "4", "S1" … as the paper, "scales",
                             ///< "spectra:NAME" …
    std::string name;        ///< stem of its files: "figure_1", "figure_S3", "scales", "spectra_NAME"
    std::string title;       ///< one line, such as "Power spectral density of every surface"
    std::string caption;     ///< what is drawn, from what, and what of it is reconstruction
    figures::Figure figure;  ///< empty where there is a reason
    std::string command;     ///< what makes it again; empty: `setae plot` of its study
    std::string reason;  ///< why it cannot be drawn, as a sentence's end: "no experiment has a contact radius"; empty
                         ///< where it can

    [[nodiscard]] bool drawable() const { return reason.empty(); }
};

/// Width of a figure in a journal.
enum class FigureWidth {
    single_column,  ///< 85 mm
    double_column,  ///< 178 mm
};

/// Figures of one kind, one for each surface or loop, that a report contains at most.
inline constexpr std::size_t max_of_a_kind_in_reports = 200;

struct GalleryOptions {
    FigureWidth width = FigureWidth::double_column;
    parallel::Threads threads;
    /// Figures "spectra:NAME", and "loop:NAME", that are made: those of the first surfaces and loops.
    std::size_t max_of_a_kind = std::numeric_limits<std::size_t>::max();
};

/// Every figure of a study, in the order of the paper and then those of our own: 1, 2, 4, S1, S2, S3, S5, S6, S8 of
/// Dalvi et al. (2019); "spectra:NAME" of every measured surface, "scales", "prediction", "replicates", "agreement".
///
/// The same result gives the same figures, for any number of threads. Never throws for what a study lacks: see
/// `reason`.
[[nodiscard]] std::vector<StudyFigure> study_figures(const study::StudyResult& result,
                                                     const GalleryOptions& options = {});

/// One of them.
/// @throws InvalidArgument for an identifier that none has, with the nearest match.
[[nodiscard]] StudyFigure study_figure(const study::StudyResult& result, const std::string& identifier,
                                       const GalleryOptions& options = {});

}  // namespace setae::study_figures
