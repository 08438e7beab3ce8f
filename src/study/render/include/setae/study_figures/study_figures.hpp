// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "setae/figures/figure.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study_figures {

/// A figure of a study, or the reason for which it cannot be drawn.
struct StudyFigure {
    /// name for `setae plot --figure`: "1", "2", "4", "S1" … as in the paper, "scales", "spectra:NAME" …
    std::string identifier;
    std::string name;        ///< stem of its files: "figure_1", "figure_S3", "scales", "spectra_NAME"
    std::string title;       ///< one line, such as "Power spectral density of every surface"
    std::string caption;     ///< content, data, and reconstructed parts
    figures::Figure figure;  ///< empty where there is a reason
    std::string command;     ///< command that makes it again; empty: `setae plot` of its study
    /// reason for which it cannot be drawn, as the end of a sentence: "no experiment has a contact radius"; empty where
    /// it can
    std::string reason;

    [[nodiscard]] bool drawable() const { return reason.empty(); }
};

/// Width of a figure in a journal.
enum class FigureWidth {
    single_column,  ///< 85 mm
    double_column,  ///< 178 mm
};

/// Maximum number of figures of one kind, one per surface or loop, in a report.
inline constexpr std::size_t max_of_a_kind_in_reports = 200;

struct GalleryOptions {
    FigureWidth width = FigureWidth::double_column;
    parallel::Threads threads;
    /// Figures "spectra:NAME", and "loop:NAME", that are made: those of the first surfaces and loops.
    std::size_t max_of_a_kind = std::numeric_limits<std::size_t>::max();
};

/// Every figure of a study, in the order of the paper and then those of setae: 1, 2, 4, S1, S2, S3, S5, S6, S8 of Dalvi
/// et al. (2019); "spectra:NAME" of every measured surface, "scales", "prediction", "replicates", "agreement".
///
/// Equal results give equal figures, for any number of threads. Never throws for missing data of a study: see `reason`.
[[nodiscard]] std::vector<StudyFigure> study_figures(const study::StudyResult& result,
                                                     const GalleryOptions& options = {});

/// One figure of a study.
/// @throws InvalidArgument for an unknown identifier, with the nearest match.
[[nodiscard]] StudyFigure study_figure(const study::StudyResult& result, const std::string& identifier,
                                       const GalleryOptions& options = {});

}  // namespace setae::study_figures
