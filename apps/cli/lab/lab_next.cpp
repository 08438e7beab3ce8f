// SPDX-License-Identifier: GPL-3.0-or-later

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/output/field_json.hpp"
#include "setae/validation/next_trials.hpp"

namespace setae::cli::lab_next_command {
namespace {

constexpr const char* explanation =
    "Each run makes the data set of the recipe with its own seed.\n"
    "`setae study --next` predicts the standard error after one further measurement.\n"
    "The run then simulates this measurement and repeats the study.\n"
    "\n"
    "input       The recipe gives the input with half its ±. The true value is half as far from the given value.\n"
    "surface     all its scans, maps and contours are repeated at other places\n"
    "pair        one more loop with its own noise\n"
    "±           standard errors, root mean square over runs: without the measurement, as promised, with the measurement\n"
    "off         found - true, root mean square, without and with the measurement\n"
    "ratio       off with the measurement over off without; its ± by leaving out runs\n"
    "promised    ratio of the promised standard errors\n";

struct NextArguments : RepeatedRecipe {
    std::string target = "W_int";
    std::vector<std::string> measured;
};

ExitCode run(const NextArguments& arguments) {
    require_recipe(arguments);
    const auto found = validation::next_trials(arguments.recipe, {.runs = arguments.runs,
                                                                  .first_seed = arguments.seed,
                                                                  .target = arguments.target,
                                                                  .measured = arguments.measured,
                                                                  .folder = arguments.output,
                                                                  .threads = arguments.common.workers(),
                                                                  .progress = progress_of(arguments.runs)});
    for (const auto& failed : found.failed) print_message(fmt::format("seed {}: {}", failed.seed, failed.reason));
    if (found.trials.empty()) return ExitCode::nothing_done;
    const auto rows = validation::summary(found.trials);
    const auto table = validation::next_summary_table(arguments.target, rows);
    const auto folder = std::filesystem::path(arguments.output);
    bytes::write_whole_file((folder / "next.txt").string(), tables::as_text(table));
    bytes::write_whole_file((folder / "trials.csv").string(),
                            tables::as_csv(validation::next_trials_table(found.trials)));
    if (arguments.common.json) {
        print_json(output::described(
            validation::NextOutput{arguments.recipe, arguments.runs, arguments.seed, arguments.target, rows}));
    } else {
        print(tables::as_text_within(table, output_size().width) +
              fmt::format("\n{} runs from seed {}; every one in {}\n", arguments.runs, arguments.seed,
                          (folder / "trials.csv").string()));
    }
    return found.failed.empty() ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<NextArguments>();
    arguments->output = "next";
    arguments->runs = 25;
    add_options(options, *arguments);
    options
        .add(
            "--measure", arguments->measured,
            "additional measurement: an input, a surface, or a pair such as \"E02 on A\"; default: the three with the largest promised effect")
        .value_named("NAME");
    options
        .add("--target", arguments->target,
             "result whose standard error the measurements should reduce: W_int, a pair such as \"E02 on A\", or the "
             "difference of two balances such as \"(7) - (10)\", as in `setae study --next`; default: W_int")
        .value_named("RESULT");
    options.example("setae lab next recipe.toml --runs 100", "promised and simulated effects of further measurements");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_next_command
