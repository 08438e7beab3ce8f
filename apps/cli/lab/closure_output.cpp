// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/closure_output.hpp"

#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/platform/terminal.hpp"
#include "setae/validation/report.hpp"

namespace setae::cli {

void add_options(Options& options, RepeatedRecipe& repeated) {
    options.add("recipe", repeated.recipe, "TOML file of the recipe").of_inputs();
    options.output("-o,--output", repeated.output, "folder of tables and figure; default: " + repeated.output);
    options.ask(repeated);
}

void require_recipe(const RepeatedRecipe& repeated) {
    if (repeated.recipe.empty())
        throw InvalidArgument("no recipe; expected a TOML file, such as examples/closure/standard.toml");
}

std::function<void(int)> progress_of(int runs) {
    if (!platform::is_terminal(platform::Stream::errors)) return {};
    return [runs](int done) { fmt::print(stderr, "\r{} of {} runs{}", done, runs, done == runs ? "\n" : ""); };
}

void write_closure(const std::vector<validation::SummaryRow>& rows, const std::string& name,
                   const std::string& folder) {
    std::error_code ignored;  // writing to a folder that cannot be created fails below
    std::filesystem::create_directories(folder, ignored);
    const auto path = [&](const char* ending) { return (std::filesystem::path(folder) / (name + ending)).string(); };
    bytes::write_whole_file(path(".txt"), validation::summary_table(rows));
    const auto figure = validation::validation_figure(rows);
    figures::write_data(figure, path(".csv"));
    for (const char* ending : {".svg", ".png", ".pdf"}) figures::draw(figure, path(ending));
}

}  // namespace setae::cli
