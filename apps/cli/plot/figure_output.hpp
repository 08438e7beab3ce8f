// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "program/options.hpp"
#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::cli {

/// --width of a figure that a verb's -o asks for by its ending.
struct FigureOption {
    std::string width = "single";

    void add_to(Options& options);
    [[nodiscard]] file_figures::Look look() const;
};

/// Writes a figure, and prints its title and caption unless `quiet`.
void write_figure(const file_figures::StudyFigure& figure, const std::string& path, bool quiet);

/// @throws InvalidArgument, before anything dear is done, for a path that ends neither as a figure nor as a table, .csv
/// or .nc; an empty one, too, passes.
void require_table_or_figure(const std::string& path);

/// A table as .csv or .nc, or the figure of it, as the path ends; where it is empty nothing.
void write_table_or_figure(const std::string& path, const Table& table,
                           const std::function<file_figures::StudyFigure()>& figure, bool quiet);

}  // namespace setae::cli
