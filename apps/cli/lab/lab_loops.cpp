// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/validation/law_recovery.hpp"
#include "setae/validation/loop_coverage.hpp"
#include "setae/validation/report.hpp"

namespace setae::cli::lab_loops_command {
namespace {

constexpr const char* explanation =
    "The command fits simulated noisy loops and compares the results with the true values.\n"
    "\n"
    "branches  E*, W and delta_0 of each fit to samples of JKR curves with noise in force, displacement and contact radius\n"
    "records   whole loops through `setae jkr fit`: free flight, jumps, pinned stretch; W differs between the branches\n"
    "SNR       largest force over sigma_F, displacement to the largest force over sigma_delta, a_max over sigma_a\n"
    "bias      mean of found/true - 1, or of found - true\n"
    "scatter   standard deviation of the results; stated: mean standard error of the fits\n"
    "coverage  share of 95 % intervals that cover the true value, with Wilson's interval of this share\n"
    "a(F)      least squares only in a (Eq. 1); a(F) both: errors in a and F; linear: linear form\n"
    "          a(F) and linear are biased for noisy data.\n"
    "\n"
    "--mechanism: the loops of the recipe have another retraction model. The study of their files should find this model.\n"
    "Models: reversible, pinning, conformal_loss, opening_work.\n"
    "Each model also exists with a crack tip (crack_tip_...) and with a crack tip that depends on speed (crack_speed_...).\n"
    "The models are described in docs/concepts/hysteresis.md. Equation numbers: Dalvi et al., PNAS 116 (2019) 25484.\n";

struct Arguments {
    Common common;
    validation::LoopCoverageOptions options;
    std::string recipe;
    std::vector<std::string> mechanisms;
    std::string output = "loop_coverage";
};

using Coverage = validation::LoopCoverageOptions;
constexpr std::array asked{
    fields::option<&Coverage::runs>("runs", "number of loops per signal-to-noise ratio, or of data sets per mechanism")
        .between(1, 1000000)
        .default_shown(),
    fields::option<&Coverage::first_seed>("seed", "seed of the first run; further runs use the next numbers")
        .default_shown(),
    fields::option<&Coverage::samples>("samples", "number of samples of each branch")
        .between(20, 1000000)
        .default_shown(),
    fields::option<&Coverage::signal_to_noise>("snr", "signal-to-noise ratios").default_shown(),
};

/// Simulates loops of a recipe with known retraction models and analyses them.
ExitCode recover_mechanisms(const Arguments& arguments) {
    if (arguments.recipe.empty())
        throw InvalidArgument(
            "no recipe; expected a TOML file whose loops get the mechanisms, see docs/guides/laboratory.md");
    const auto laws = validation::simulated_models(arguments.mechanisms);
    const int data_sets = arguments.options.runs * static_cast<int>(laws.size());
    const auto found = validation::model_recoveries(arguments.recipe, laws,
                                                    {.runs = arguments.options.runs,
                                                     .first_seed = arguments.options.first_seed,
                                                     .folder = arguments.output,
                                                     .threads = arguments.common.workers(),
                                                     .progress = progress_of(data_sets)});
    for (const auto& failed : found.failed) print_message(fmt::format("seed {}: {}", failed.seed, failed.reason));
    if (found.recoveries.empty()) return ExitCode::nothing_done;
    const auto rows = validation::summary(found.recoveries);
    const auto table = validation::model_summary_table(rows);
    const auto folder = std::filesystem::path(arguments.output);
    bytes::write_whole_file((folder / "mechanisms.txt").string(), tables::as_text(table));
    bytes::write_whole_file((folder / "mechanisms.csv").string(),
                            tables::as_csv(validation::model_recovery_table(found.recoveries)));
    if (arguments.common.json) {
        print_json(output::described(validation::MechanismsOutput{arguments.recipe, arguments.options.runs,
                                                                  arguments.options.first_seed, rows}));
    } else {
        print(
            tables::as_text_within(table, output_size().width) +
            fmt::format(
                "\noff: leave-one-surface-out error of the model found; neither found nor excluded: cannot be distinguished\n"
                "data sets from seed {}; every one in {}\n",
                arguments.options.first_seed, (folder / "mechanisms.csv").string()));
    }
    return found.failed.empty() ? ExitCode::done : ExitCode::some_failed;
}

ExitCode fit_simulated_loops(const Arguments& arguments) {
    auto options = arguments.options;
    options.threads = arguments.common.workers();
    options.progress = progress_of(options.runs);
    auto comparisons = validation::branch_coverage(options);
    const auto records = validation::record_coverage(options);
    comparisons.insert(comparisons.end(), records.begin(), records.end());
    const auto rows = validation::summary(comparisons);
    write_closure(rows, "loop_coverage", arguments.output);
    bytes::write_whole_file((std::filesystem::path(arguments.output) / "comparisons.csv").string(),
                            validation::comparisons_csv(comparisons));
    if (arguments.common.json)
        print_json(output::described(validation::LoopsOutput{options.runs, options.first_seed, options.samples, rows}));
    else
        print(validation::summary_table(rows) +
              fmt::format("\n{} runs from seed {}, {} samples per branch; every comparison in {}/comparisons.csv\n",
                          options.runs, options.first_seed, options.samples, arguments.output));
    return ExitCode::done;
}

ExitCode run(const Arguments& arguments) {
    if (!arguments.mechanisms.empty()) return recover_mechanisms(arguments);
    if (!arguments.recipe.empty())
        throw InvalidArgument(
            "a recipe without --mechanism; expected --mechanism, or no recipe: the command then simulates its own loops");
    return fit_simulated_loops(arguments);
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("recipe", arguments->recipe, "TOML file of a recipe whose loops get the mechanisms of --mechanism")
        .of_inputs();
    options
        .add(
            "--mechanism", arguments->mechanisms,
            "mechanisms of hysteresis in the loops of the recipe, which the study should find: all, or names of models")
        .value_named("NAME");
    options.output("-o,--output", arguments->output, "folder of tables and figure").default_shown();
    options.ask(asked, &arguments->options);
    options.example("setae lab loops --runs 20 -o loops", "coverage of the intervals of fitted loops");
    options.example("setae lab loops recipe.toml --mechanism all --runs 1 -o mechanisms",
                    "share of studies that find the retraction model of their loops");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_loops_command
