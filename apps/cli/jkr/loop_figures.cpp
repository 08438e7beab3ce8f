// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/loop_figures.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "program/messages.hpp"
#include "setae/study_figures/write_figures.hpp"

namespace setae::cli {

std::string figure_name(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void write_loop_figures(const std::vector<study_figures::StudyFigure>& figures, const std::string& folder,
                        parallel::Threads threads) {
    for (const auto& figure : figures)
        if (!figure.drawable()) print_message(fmt::format("no figure {}: {}", figure.name, figure.reason));
    for (const auto& written : study_figures::write_figures(figures, {.folder = folder, .threads = threads}))
        if (!written.error.empty()) print_message(fmt::format("{}: {}", written.name, written.error));
}

}  // namespace setae::cli
