// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

struct WriteOptions {
    std::string folder;  ///< made where missing
    /// returns the path of a file in the folder, or refuses it, from any thread; default: its name in the folder
    std::function<std::string(const std::string& file)> path_of;
    std::string study;                               ///< path of the study, for the command that makes a figure again
    FigureWidth width = FigureWidth::double_column;  ///< width of the figures, for that command
    std::vector<std::string> endings{"svg", "pdf", "png", "csv"};
    parallel::Threads threads;
    const cache::Store* store = nullptr;                    ///< figures drawn before are taken from it
    std::function<void(const std::string& name)> progress;  ///< after each figure, one call at a time
    const std::atomic<bool>* cancelled = nullptr;           ///< once true, no new figure is started
};

/// Result of writing a figure.
struct WrittenFigure {
    std::string name;                ///< as StudyFigure::name
    std::vector<std::string> files;  ///< within the folder, in the order of the endings
    std::string error;               ///< reason for missing files; empty where none is missing
};

/// Writes every drawable figure as NAME.ending, each file as a whole. A failed figure does not affect the others.
///
/// Files are drawn on many threads; equal figures give equal bytes for any number, and from the store. @throws
/// FileError where the folder cannot be made; Cancelled where the options say so.
std::vector<WrittenFigure> write_figures(const std::vector<StudyFigure>& figures, const WriteOptions& options);

/// The command that makes a figure again: "setae plot STUDY --figure ID -o NAME.svg".
[[nodiscard]] std::string command_of(const StudyFigure& figure, const std::string& study,
                                     FigureWidth width = FigureWidth::double_column);

/// The numbers of a figure as CSV, after lines "# …" with its title, identifier, caption, the version of setae and the
/// command that makes it again.
[[nodiscard]] std::string data_of(const StudyFigure& figure, const std::string& study,
                                  FigureWidth width = FigureWidth::double_column);

/// A drawable figure as bytes of an svg, pdf or png, from the store where it was drawn before by the same gnuplot.
/// @throws as figures::drawn.
[[nodiscard]] std::string bytes_of(const StudyFigure& figure, const std::string& ending,
                                   const cache::Store* store = nullptr);

}  // namespace setae::study_figures
