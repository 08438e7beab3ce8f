// SPDX-License-Identifier: GPL-3.0-or-later

#include <memory>

#include <fmt/format.h>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/output/field_json.hpp"
#include "setae/validation/causes.hpp"
#include "setae/validation/report.hpp"

namespace setae::cli::lab_causes_command {
namespace {

constexpr const char* explanation =
    "The command computes the bias of the arithmetic mean of spectra [D19] for the surfaces of a recipe, cause by cause.\n"
    "Every periodogram is replaced by its expectation with only one cause, so that the results have no scatter.\n"
    "\n"
    "none              C1D at the wavevectors of the measurements, inside their reliable bands\n"
    "segments          straight lines between the points of contours\n"
    "trend and window  parabola (stylus) or tilt (lines of maps) removed, Hann window\n"
    "aliasing          waves shorter than two pixels\n"
    "tip               spherical instead of point-like, inside the band of its criterion\n"
    "eq. (11)          C_iso = pi C1D/(q sqrt(1 - (q/q_s)^2)) instead of the exact moments\n"
    "all               all causes together\n"
    "\n"
    "work_of_adhesion: W_int from the true W_app, for E* = 1 MPa and gamma_1 = 25 mJ/m2.\n"
    "..._from_loss: W_int r/r_found.\n"
    "[D19] Dalvi et al., PNAS 116 (2019) 25484.\n";

ExitCode run(const RepeatedRecipe& arguments) {
    require_recipe(arguments);
    const auto rows =
        validation::summary(validation::readings_by_cause(arguments.recipe, {.runs = arguments.runs,
                                                                             .first_seed = arguments.seed,
                                                                             .folder = arguments.output,
                                                                             .threads = arguments.common.workers(),
                                                                             .progress = progress_of(arguments.runs)}));
    write_closure(rows, "causes", arguments.output);
    if (arguments.common.json)
        print_json(
            output::described(validation::RecipeSummary{arguments.recipe, arguments.runs, arguments.seed, rows}));
    else print(validation::bias_table(rows) + fmt::format("\n{} runs from seed {}\n", arguments.runs, arguments.seed));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<RepeatedRecipe>(RepeatedRecipe{.output = "causes", .runs = 5});
    add_options(options, *arguments);
    options.example("setae lab causes recipe.toml", "bias of every cause");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_causes_command
