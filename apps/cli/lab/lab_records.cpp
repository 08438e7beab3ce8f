// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "lab/closure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/output/field_json.hpp"
#include "setae/validation/record_trials.hpp"

namespace setae::cli::lab_records_command {
namespace {

constexpr const char* explanation =
    "The command analyses simulated loops of a sphere. Each record has one fault, or two, as they occur in experiments.\n"
    "\n"
    "columns        median bias in percent, median bias in standard errors, share of 95 % intervals that cover the true value\n"
    "E*, W          modulus and work of adhesion of the fit to loading\n"
    "W_ret          W_pull_off: at pull-off, from the smallest force\n"
    "               W_last_points: at pull-off, from the last samples of retraction\n"
    "E_loss         energy of the loop\n"
    "refused        records that are not analysed\n"
    "cause named    records that are refused or get a warning, with the fault named\n"
    "silently wrong records with a result off by more than four standard errors and 2 %\n"
    "               Neither a refusal nor a warning names the fault.\n";

struct Arguments {
    Common common;
    validation::RecordTrialOptions options;
    std::string output = "records";
    bool list = false;
};

using Trials = validation::RecordTrialOptions;
constexpr std::array asked{
    fields::option<&Trials::pairs>("pairs", "records with two faults instead of one"),
    fields::option<&Trials::runs>("runs", "number of records of each kind or pair").between(1, 1000000).default_shown(),
    fields::option<&Trials::first_seed>("seed", "seed of the first record; further records use the next numbers")
        .default_shown(),
};

ExitCode print_kinds() {
    std::string text;
    for (const auto& kind : validation::record_kinds()) text += fmt::format("{:<28} {}\n", kind.name, kind.meaning);
    print(text);
    return ExitCode::done;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.list) return print_kinds();
    auto options = arguments.options;
    options.threads = arguments.common.workers();
    options.progress = progress_of(validation::number_of_trials(options));
    const auto trials = validation::record_trials(options);
    auto rows = validation::summary(trials);
    rows.push_back(validation::summary(trials, "all"));
    const auto table = validation::record_table(rows);
    const std::filesystem::path folder(arguments.output);
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    bytes::write_whole_file((folder / "records.md").string(), table);
    bytes::write_whole_file((folder / "records.csv").string(), validation::record_csv(trials));
    if (arguments.common.json) {
        print_json(output::described(validation::RecordsOutput{options.runs, options.first_seed, options.pairs, rows}));
    } else {
        print(table + fmt::format("\n{} records of each from seed {}; every result in {}\n", options.runs,
                                  options.first_seed, (folder / "records.csv").string()));
    }
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("kinds", arguments->options.kinds, "kinds of records; default: all");
    options.flag("--list", arguments->list, "print the kinds of records, then stop");
    options.ask(asked, &arguments->options);
    options.output("-o,--output", arguments->output, "folder of records.md and records.csv").default_shown();
    options.example("setae lab records --runs 200 -o records",
                    "bias and coverage of all results for every kind of record");
    options.example("setae lab records drift_100 hold camera --pairs --runs 10", "three faults in pairs");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_records_command
