// SPDX-License-Identifier: GPL-3.0-or-later

#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/validation/loop_coverage.hpp"
#include "setae/validation/report.hpp"

namespace setae::cli::lab_loops_command {
namespace {

constexpr const char* explanation =
    "branches   E*, W and delta_0 of each fit on samples of JKR's curves with noise in force, displacement and contact radius\n"
    "records    whole loops through `setae jkr fit`: free flight, jumps, the pinned stretch; W differs between the branches\n"
    "SNR        largest force over sigma_F; displacement to the largest force over sigma_delta; a_max over sigma_a\n"
    "bias       mean of found/planted - 1, or of found - planted;  scatter, stated: standard deviation found, and claimed\n"
    "holds      share of 95 % intervals that hold the planted value, with Wilson's interval for that share\n"
    "a(F)       least squares in a alone, (1); a(F) both: errors in both; linear: the linear form. a(F) and linear are biased where noisy\n";

struct Arguments {
    Common common;
    validation::LoopCoverageOptions options;
    std::string output = "loop_coverage";
};

ExitCode run(const Arguments& arguments) {
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
        print_json({{"runs", options.runs},
                    {"first_seed", options.first_seed},
                    {"samples", options.samples},
                    {"rows", json_of(rows)}});
    else
        print(validation::summary_table(rows) +
              fmt::format("\n{} runs from seed {}, {} samples a branch; every comparison in {}/comparisons.csv\n",
                          options.runs, options.first_seed, options.samples, arguments.output));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("-o,--output", arguments->output, "folder of tables and figure").default_shown();
    options.add("--runs", arguments->options.runs, "loops at each signal-to-noise ratio")
        .between(1, 1000000)
        .default_shown();
    options.add("--seed", arguments->options.first_seed, "of the first run").default_shown();
    options.add("--samples", arguments->options.samples, "of each branch").between(20, 1000000).default_shown();
    options.add("--snr", arguments->options.signal_to_noise, "signal-to-noise ratios").default_shown();
    options.example("setae lab loops --runs 20 -o loops", "whether intervals of fitted loops hold the truth");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_loops_command
