// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/workflow/study_tables.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

constexpr const char* explanation =
    "likelihood  C_iso with the largest -sum nu (ln E + P/E), E the periodogram it expects of each measurement\n"
    "average     C1D(q) = |h(q)|^2/L, averaged over measurements in decade-aligned bins        [D19], [J17]\n"
    "parameters  h_rms^2 = (1/pi) int C1D dq, h'^2 = (2/pi) int q^2 C1D dq                      exact, isotropic surfaces\n"
    "            U_el/(A_app E*) = (1/8) int q C1D dq                                          [D19] (8)\n"
    "true area   A_true/A_app = 1 + sqrt(pi)/2 h' exp(1/h'^2) erfc(1/h')                        [D19] (9)\n"
    "balance     W_app = W_int r - gamma_1 (r - 1) - U_el/A_app, r = A_true/A_app               [D19] (7)\n"
    "comparison  W_app = W_int (1 + h'^2/2) - U_el/A_app                                        [D19] (S13)\n"
    "loading     a^3 = 3R/(4E*) (F + 3 pi R W + sqrt(6 pi R W F + (3 pi R W)^2))                [D19] (1)\n"
    "loss        E_loss = W_int A_true, A_true = r pi a_max^2                                   [D19] (10)\n"
    "[D19] Dalvi et al., PNAS 116 (2019) 25484; [J17] Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001\n";

struct Arguments {
    Common common;
    std::string file;
    std::string output;
};

void show_failures(const workflow::StudyResult& result) {
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) complain(fmt::format("surface {}: {}", surface.name, surface.error));
        for (const auto& m : surface.measurements)
            if (m.failed()) complain(fmt::format("surface {}: {}", surface.name, m.error));
    }
    for (const auto& e : result.experiments)
        if (e.failed()) complain(e.error);
}

ExitCode run(const Arguments& arguments) {
    if (arguments.file.empty()) throw InvalidArgument("no study; expected a TOML file, see docs/study.md");
    auto study = workflow::read_study(arguments.file);
    if (!arguments.output.empty()) study.output = arguments.output;
    const auto result = workflow::run_study(std::move(study), {arguments.common.workers()});
    show_failures(result);
    const auto files = workflow::write_results(result);
    if (arguments.common.json) {
        print_json(workflow::to_json(result));
    } else {
        print(workflow::summary(result));
        for (const auto& row : workflow::alert_table(result).rows)
            complain(fmt::format("{}: {}: {}", std::get<std::string>(row[0]), std::get<std::string>(row[1]), std::get<std::string>(row[2])));
        print(fmt::format("Results: {} ({} files)\n", result.study.output, files.size()));
    }
    if (result.failures() == 0) return ExitCode::done;
    return result.successes() > 0 ? ExitCode::some_failed : ExitCode::nothing_done;
}

}  // namespace

void add_study(CLI::App& program, Action& action) {
    auto arguments = std::make_shared<Arguments>();
    auto* verb = program.add_subcommand("study", "run a study: surfaces, elastomers, experiments → tables and fits");
    verb->add_option("file", arguments->file, "TOML file of the study");
    verb->add_option("--output", arguments->output, "folder of the results; default: beside the study");
    on_named(*verb, action, arguments, explanation, run);
}

}  // namespace setae::cli
