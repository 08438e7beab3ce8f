// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/gallery/study_figures.hpp"

namespace setae::gallery {

struct WriteOptions {
    std::string folder;                                              ///< made where missing
    std::string study;                                               ///< path of the study, as the command that makes a figure again names it
    FigureWidth width = FigureWidth::double_column;                  ///< likewise
    std::vector<std::string> endings{"svg", "pdf", "png", "csv"};
    parallel::Threads threads;
    const cache::Store* store = nullptr;                             ///< figures drawn before are taken from it
    std::function<void(const std::string& name)> progress;           ///< after each figure, one call at a time
};

/// What became of a figure.
struct WrittenFigure {
    std::string name;                ///< as StudyFigure::name
    std::vector<std::string> files;  ///< within the folder, in the order of the endings
    std::string error;               ///< why the others are missing; empty where none is
};

/// Writes every drawable figure as NAME.ending, each file as a whole. One that fails never loses the others.
///
/// Files are drawn on many threads; the same figures give the same bytes for any number, and from the store.
/// @throws FileError where the folder cannot be made.
std::vector<WrittenFigure> write_figures(const std::vector<StudyFigure>& figures, const WriteOptions& options);

/// The numbers of a figure as CSV, under lines "# …" that say its title, identifier, the version of setae and the command that makes
/// it again.
[[nodiscard]] std::string data_of(const StudyFigure& figure, const WriteOptions& options);

}  // namespace setae::gallery
