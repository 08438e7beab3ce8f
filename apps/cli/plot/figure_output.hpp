// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "program/options.hpp"
#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::cli {

/// Option --width of a command that draws a figure if -o has the ending of a figure.
struct FigureOption {
    std::string width = "single";

    void add_to(Options& options);
    [[nodiscard]] file_figures::Look look() const;
};

/// Writes a figure, and prints its title and caption unless `quiet`.
void write_figure(const file_figures::StudyFigure& figure, const std::string& path, bool quiet);

/// @throws InvalidArgument for a path that ends neither as a figure nor as a table, .csv or .nc. Called before long
/// calculations. An empty path is accepted.
void require_table_or_figure(const std::string& path);

/// Writes a table as .csv or .nc, or its figure, by the ending of the path; nothing for an empty path.
void write_table_or_figure(const std::string& path, const Table& table,
                           const std::function<file_figures::StudyFigure()>& figure, bool quiet);

}  // namespace setae::cli
