// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/file_figures/predicted_loop_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/file_names.hpp"
#include "setae/output/hysteresis_fields.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/parallel/cancellation.hpp"
#include "setae/study/hysteresis.hpp"
#include "setae/study_figures/hysteresis_figures.hpp"
#include "setae/study_figures/write_figures.hpp"
#include "study/interruption.hpp"
#include "study/run_arguments.hpp"

namespace setae::cli::predict_command {
namespace {

constexpr const char* explanation =
    "The command predicts W_ret at pull-off, the pull-off force and the energy loss of every pair of a study from roughness.\n"
    "Pairs without measured loops are predicted, too.\n"
    "\n"
    "W_app     full-contact balance (Eq. 7) with W_int of the study\n"
    "W_ret     at pull-off, by the likeliest retraction model whose W_ret tends to that of a smooth surface\n"
    "          A likelier model without this limit is printed next to it.\n"
    "          Fewer than 6 pairs with W_ret: W_app, a lower bound.\n"
    "W_x       work per unit true area at pull-off, which may differ from that of the whole retraction\n"
    "E_loss    loss of the jumps of the sphere with its testing machine + (W_ret - W_app) π a_max²\n"
    "          E_loss needs sphere_radius and preload.\n"
    "Pairs without spontaneous full contact, U_el/AW > 0.3, are predicted with the ranking of all pairs.\n"
    "\n"
    "Retraction models, each also times a crack tip:\n"
    "crack tip       φ = W_ret/W_app of a smooth reference on the same elastomer\n"
    "                The smooth reference is assumed to have the chemistry of the rough surfaces.\n"
    "reversible      W_app\n"
    "pinning         W_app + 2k U_el/A; k simulated, by bands, or fitted\n"
    "                The simulated k increases with N, the number of Larkin lengths of the edge.\n"
    "                N is taken at the largest load and at pull-off.\n"
    "conformal_loss  W_app + W_int A_true/A, true-area loss (Eq. 10), or with another work per unit true area\n"
    "opening_work    W_x A_true/A\n"
    "\n"
    "left-out error  rms of measured minus predicted, leave-one-surface-out and leave-one-elastomer-out\n"
    "odds            for the best retraction model against each other model, from leave-one-surface-out predictions\n"
    "\n"
    "The models are described in docs/concepts/hysteresis.md. Equation numbers: Dalvi et al., PNAS 116 (2019) 25484.\n";

struct PredictArguments {
    Common common;
    RunArguments run;
    std::string study;
    std::string output;
    int trials = 0;
    std::uint64_t seed = 1;
    FigureOption figure;
};

constexpr std::array asked{
    fields::option<&PredictArguments::trials>(
        "trials",
        "number of simulated data sets per retraction model, with the errors of these pairs; the fits rank the models")
        .within(domain::positive),
    fields::option<&PredictArguments::seed>("seed", "seed of the first trial; further trials use the next numbers")
        .default_shown(),
};

void write_tables(const study::Hysteresis& hysteresis, const std::filesystem::path& folder) {
    for (const auto& [name, table] : output::hysteresis_tables(hysteresis))
        bytes::write_whole_file((folder / name).string(), tables::as_csv(table));
}

std::vector<file_figures::StudyFigure> figures_of(const study::Hysteresis& hysteresis, const study::StudyResult& result,
                                                  const file_figures::Look& look) {
    std::vector<file_figures::StudyFigure> figures{study_figures::hysteresis_figure(hysteresis, look.width),
                                                   study_figures::loss_shares_figure(hysteresis, look.width)};
    for (auto& figure : figures) figure.command = look.command;
    for (const auto& pair : hysteresis.pairs)
        figures.push_back(file_figures::predicted_loop_figure(pair, result, look));
    std::vector<std::string> names;
    for (const auto& figure : figures) names.push_back(figure.name);
    names = output::file_names(names);
    for (std::size_t i = 0; i < figures.size(); ++i) figures[i].name = names[i];
    return figures;
}

/// Writes the figures; returns the number of figures that failed.
int write_figures(const std::vector<file_figures::StudyFigure>& figures, const PredictArguments& arguments,
                  const cache::Store& store) {
    study_figures::WriteOptions options;
    options.folder = (std::filesystem::path(arguments.output) / "figures").string();
    options.study = arguments.study;
    options.threads = arguments.common.workers();
    options.store = &store;
    options.cancelled = &interruption();
    int failed = 0;
    for (const auto& figure : study_figures::write_figures(figures, options))
        if (!figure.error.empty() && failed++ == 0)
            print_message(fmt::format("figure {}: {}", figure.name, figure.error));
    return failed;
}

ExitCode predict(const PredictArguments& arguments, const cache::Store& store, ProgressDisplay& display) {
    const auto study = study::read_study(arguments.study, mapping_folder());
    show(study.alerts);
    const auto result = study::run_study(study, run_options(arguments.common.workers(), store, display));
    display.finish();
    for (const auto& surface : result.surfaces)
        if (surface.failed()) print_message(fmt::format("surface {}: {}", surface.name, surface.error));
    std::optional<hysteresis::TrialOptions> trials;
    if (arguments.trials > 0)
        trials = {.runs = arguments.trials,
                  .seed = arguments.seed,
                  .threads = arguments.common.workers(),
                  .cancelled = &interruption()};
    const parallel::CancellationScope scope(interruption());
    const auto hysteresis = result.hysteresis && !trials
                                ? *result.hysteresis
                                : study::hysteresis_of(result, trials, arguments.common.workers());
    show(hysteresis.alerts);
    int failures = result.failures();
    if (!arguments.output.empty()) {
        std::filesystem::create_directories(arguments.output);
        write_tables(hysteresis, arguments.output);
        failures += write_figures(figures_of(hysteresis, result, arguments.figure.look()), arguments, store);
    }
    if (arguments.common.json) print_json(output::described(output::HysteresisEntry{&hysteresis}));
    else print(output::hysteresis_text(hysteresis, output_size().width));
    return failures == 0 ? ExitCode::done : ExitCode::some_failed;
}

ExitCode run(const PredictArguments& arguments) {
    if (arguments.study.empty()) throw InvalidArgument("no study; expected a TOML file, see docs/guides/study.md");
    const auto store = arguments.run.store();
    ProgressDisplay display(arguments.run.progress_mode());
    return until_interrupted(store, display, [&] { return predict(arguments, store, display); });
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<PredictArguments>();
    options.add("study", arguments->study, "TOML file of the study").of_inputs();
    options.output(
        "-o,--output", arguments->output,
        "folder for hysteresis.csv, models.csv, model_works.csv, losses.csv, and figures of them and of each loop");
    options.ask(asked, arguments.get());
    arguments->figure.add_to(options);
    arguments->run.add_to(options);
    options.example("setae predict study.toml",
                    "W_ret, pull-off force and loss of every pair, with the ranking of retraction models");
    options.example("setae predict study.toml -o retraction", "predictions as tables and figures");
    options.example("setae predict study.toml --trials 20",
                    "simulated test: retraction models that such measurements can distinguish");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::predict_command
