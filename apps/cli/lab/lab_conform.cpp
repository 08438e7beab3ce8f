// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/command_line.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/patch_survey_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/layout.hpp"
#include "setae/file_figures/patch_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/parallel/cancellation.hpp"
#include "setae/platform/terminal.hpp"
#include "study/interruption.hpp"
#include "study/run_arguments.hpp"

namespace setae::cli::lab_conform_command {
namespace {

constexpr const char* explanation =
    "The command tests whether full contact forms, as the full-contact balance (Eq. 7) assumes.\n"
    "It simulates random patches: periodic cells on an elastic half-space with an attraction of finite range.\n"
    "Their only input is the spectrum. The method is described in docs/concepts/conformity.md.\n"
    "\n"
    "U_el/AW    e, energy stored in full contact over the energy gained, W = W_int r - γ1 (r - 1)\n"
    "           Slopes enter to first order, only through W.\n"
    "from far   patches approached from above the highest point, without load: area in contact, and gain over W\n"
    "           The full-contact balance (Eq. 7) gives the gain 1 - e.\n"
    "preload    pressed at h'E*, then without load\n"
    "p closes   pressure over h'E* at which 99 % of the area touch, to 3 %\n"
    "T opens    tension over σ that opens full contact\n"
    "range      ρ of the grid, w dx/(E*ρ²) = --squared-ratio\n"
    "           Finer grids (--shortest-wave) have shorter ranges relative to the height.\n"
    "--loops    approach from far, full contact and retraction\n"
    "           Even a flat cell loses 0.35 W, because it jumps as a whole. The loss of a cell is not that of a contact.\n"
    "STUDY      patches have the U_el/AW of the pairs and the spectra of their surfaces where most energy is stored\n";

struct ConformArguments : answers::PatchSurveyRequest {
    Common common;
    RunArguments run;
    std::string study, output;
};

/// Number of patches done, on one line of a terminal.
answers::PatchProgress progress_line() {
    if (!platform::is_terminal(platform::Stream::errors)) return {};
    return [](std::size_t done, std::size_t of) {
        fmt::print(stderr, "\r{} of {} patches{}", done, of, done == of ? "\n" : "");
    };
}

answers::PatchSurveyAnswer survey_of_study(const ConformArguments& arguments, const cache::Store& store,
                                           ProgressDisplay& display) {
    const auto result = study::run_study(study::read_study(arguments.study, mapping_folder()),
                                         run_options(arguments.common.workers(), store, display));
    display.finish();
    return answers::patch_survey(result, arguments, arguments.common.workers(), progress_line());
}

/// Writes table and figure.
ExitCode write(const answers::PatchSurveyAnswer& answer, const ConformArguments& arguments) {
    const std::filesystem::path folder = arguments.output;
    std::filesystem::create_directories(folder);
    bytes::write_whole_file((folder / "conform.csv").string(), tables::as_csv(answers::patch_survey_table(answer)));
    const auto figure = file_figures::patch_figure(
        answer.rows, {.width = file_figures::FigureWidth::double_column, .command = command_line()});
    return for_each_item({"conform.svg", "conform.png", "conform.pdf"}, [&](const std::string& name) {
        file_figures::write_figure(figure, (folder / name).string());
    });
}

ExitCode show(const answers::PatchSurveyAnswer& answer, const ConformArguments& arguments) {
    for (const auto& skipped : answer.skipped) print_message(skipped);
    if (arguments.common.json) {
        print_json(output::described(answer));
    } else {
        const auto width = output_size().width;
        print(wrapped(answers::sentence(answer), width) + "\n\n" +
              tables::as_text_within(answers::patch_screen_table(answer), width, 3));
    }
    const bool written = arguments.output.empty() || write(answer, arguments) == ExitCode::done;
    return written && answer.skipped.empty() ? ExitCode::done : ExitCode::some_failed;
}

ExitCode run(const ConformArguments& arguments) {
    if (arguments.study.empty())
        return show(answers::patch_survey(arguments, arguments.common.workers(), progress_line()), arguments);
    const auto store = arguments.run.store();
    ProgressDisplay display(arguments.run.progress_mode());
    return until_interrupted(store, display, [&] {
        const parallel::CancellationScope scope(interruption());
        return show(survey_of_study(arguments, store, display), arguments);
    });
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<ConformArguments>();
    options
        .add("study", arguments->study,
             "TOML file of a study whose pairs are simulated; default: patches of --energy-share")
        .of_inputs();
    options.output("-o,--output", arguments->output, "folder for the table and the figure");
    options.ask<answers::PatchSurveyRequest>(*arguments);
    arguments->run.add_to(options);
    options.example("setae lab conform",
                    "range and accuracy of the full-contact balance (Eq. 7) against stored energy");
    options.example("setae lab conform study.toml -o patches", "patches with the spectra of the pairs of a study");
    options.example("setae lab conform --points 128,256 --shortest-wave 8 --seeds 20",
                    "patches with two bands of wavelengths");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_conform_command
