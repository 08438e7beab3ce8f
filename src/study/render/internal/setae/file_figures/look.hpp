// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/study_figures/study_figures.hpp"

namespace setae::file_figures {

using study_figures::FigureWidth;
using study_figures::StudyFigure;

/// Format of the figure of a command.
struct Look {
    FigureWidth width = FigureWidth::single_column;
    std::string command;  ///< command that makes it again, for the data's header

    [[nodiscard]] bool wide() const { return width == FigureWidth::double_column; }
};

/// Endings of figures, for messages: ".svg, .pdf or .png".
inline constexpr const char* figure_endings = ".svg, .pdf or .png";

/// Whether a path ends as a figure does.
[[nodiscard]] bool is_figure_path(const std::string& path);

/// Writes a figure in the form that its path ends with.
/// @throws UndefinedDataError with the reason where it cannot be drawn; InvalidArgument for another ending; as
/// figures::drawn.
void write_figure(const StudyFigure& figure, const std::string& path);

}  // namespace setae::file_figures
