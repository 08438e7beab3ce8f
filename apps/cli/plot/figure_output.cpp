// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/figure_output.hpp"

#include <fmt/format.h>

#include "program/command_line.hpp"
#include "program/messages.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli {

void FigureOption::add_to(Options& options) {
    options
        .output("--width", width,
                "width of a figure, one or two columns of a journal: single (85 mm) or double (178 mm)")
        .one_of({"single", "double"})
        .default_shown();
}

file_figures::Look FigureOption::look() const {
    return {.width =
                width == "single" ? file_figures::FigureWidth::single_column : file_figures::FigureWidth::double_column,
            .command = command_line()};
}

void write_figure(const file_figures::StudyFigure& figure, const std::string& path, bool quiet) {
    file_figures::write_figure(figure, path);
    if (!quiet) print(fmt::format("{}: {}\n{}\n", path, figure.title, figure.caption));
}

void require_table_or_figure(const std::string& path) {
    if (path.empty() || path.ends_with(".csv") || path.ends_with(".nc") || file_figures::is_figure_path(path)) return;
    throw InvalidArgument(fmt::format("{}: cannot tell the format from the name; expected an ending .csv, .nc, {}",
                                      path, file_figures::figure_endings));
}

void write_table_or_figure(const std::string& path, const Table& table,
                           const std::function<file_figures::StudyFigure()>& figure, bool quiet) {
    if (file_figures::is_figure_path(path)) write_figure(figure(), path, quiet);
    else if (path.ends_with(".nc")) formats::write_netcdf(path, table);
    else if (!path.empty()) tables::write_csv(path, table);
}

}  // namespace setae::cli
