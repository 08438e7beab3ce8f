// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/output/field_json.hpp"
#include "setae/validation/report.hpp"
#include "setae/validation/validation.hpp"

namespace setae::cli::lab_closure_command {
namespace {

constexpr const char* explanation =
    "Each run makes the data set of the recipe with its own seed, analyses its files and compares results with true values.\n"
    "\n"
    "bias       mean of found/true - 1, or of found - true; its standard error from the scatter between runs\n"
    "scatter    standard deviation of found/true - 1 or of found - true\n"
    "stated     mean half width of the 95 % intervals over 1.96\n"
    "coverage   share of 95 % intervals that cover the true value, with Wilson's interval of this share\n"
    "methods    likelihood, average: spectra of the study\n"
    "           loops: JKR analysis of single loops\n"
    "           pairs, elastomers: results of the study from all their loops\n"
    "           paper: Eq. 11, straight segments between contour points, percentile bootstrap [D19]\n"
    "new_pair   predictions of pairs that were not measured together (unmeasured of the recipe's [loops])\n"
    "--without  tip-factor: tips are not simulated; tip-band: data beyond the reliable band are used\n"
    "           Both change the likelihood.\n"
    "\n"
    "[D19] Dalvi et al., PNAS 116 (2019) 25484.\n";

struct ClosureArguments : RepeatedRecipe {
    bool keep = false;
    std::string spectrum = "likelihood";
    std::vector<std::string> without;
};

constexpr std::array<std::string_view, 2> spectra{"average", "likelihood"}, ingredients{"tip-factor", "tip-band"};
constexpr std::array asked{
    fields::option<&ClosureArguments::keep>("keep", "keep the data sets in the folder"),
    fields::option<&ClosureArguments::spectrum>("spectrum", "spectrum for fits and predictions")
        .one_of(spectra)
        .default_shown(),
    fields::option<&ClosureArguments::without>("without", "part of the likelihood that is left out")
        .one_of(ingredients),
};

validation::ValidationOptions options_of(const ClosureArguments& arguments) {
    const auto left_out = [&](const char* name) {
        return std::find(arguments.without.begin(), arguments.without.end(), name) != arguments.without.end();
    };
    return {.runs = arguments.runs,
            .first_seed = arguments.seed,
            .folder = arguments.output,
            .keep = arguments.keep,
            .spectrum =
                arguments.spectrum == "average" ? study::SpectrumMethod::average : study::SpectrumMethod::likelihood,
            .tip_factor = !left_out("tip-factor"),
            .tip_band = !left_out("tip-band"),
            .threads = arguments.common.workers(),
            .progress = progress_of(arguments.runs)};
}

ExitCode run(const ClosureArguments& arguments) {
    require_recipe(arguments);
    const auto found = validation::run_validation(arguments.recipe, options_of(arguments));
    for (const auto& failed : found.failed) print_message(fmt::format("seed {}: {}", failed.seed, failed.reason));
    if (found.comparisons.empty()) return ExitCode::nothing_done;
    const auto rows = validation::summary(found.comparisons);
    write_closure(rows, "closure", arguments.output);
    bytes::write_whole_file((std::filesystem::path(arguments.output) / "comparisons.csv").string(),
                            validation::comparisons_csv(found.comparisons));
    if (arguments.common.json)
        print_json(
            output::described(validation::RecipeSummary{arguments.recipe, arguments.runs, arguments.seed, rows}));
    else
        print(validation::summary_table(rows) +
              fmt::format("\n{} runs from seed {}; every comparison in {}/comparisons.csv\n", arguments.runs,
                          arguments.seed, arguments.output));
    return found.failed.empty() ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<ClosureArguments>();
    arguments->output = "closure";
    arguments->runs = 25;
    add_options(options, *arguments);
    options.ask(asked, arguments.get());
    options.example("setae lab closure recipe.toml --runs 20", "bias and coverage of all results in 20 data sets");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_closure_command
