// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/pages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/run_time.hpp"
#include "setae/answers/study_plan.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/output/budget.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/next_measurement_output.hpp"
#include "setae/output/result_folder.hpp"
#include "setae/output/screen.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/report/report.hpp"
#include "setae/study/next_measurement.hpp"
#include "setae/study_figures/write_figures.hpp"
#include "study/interruption.hpp"
#include "study/run_arguments.hpp"
#include "study/study_pages.hpp"

namespace setae::cli::study_command {
namespace {

constexpr const char* explanation =
    "The command analyses surfaces, elastomers and loops together and fits W_int.\n"
    "\n"
    "likelihood                         C_iso with the largest -sum nu (ln E + P/E)\n"
    "                                   E is the expected periodogram of each measurement, P the measured one.\n"
    "average                            C1D(q) = |h(q)|^2/L, averaged in decade-aligned bins [D19], [J17]\n"
    "rms height                         h_rms^2 = (1/pi) int C1D dq\n"
    "rms slope                          h'^2 = (2/pi) int q^2 C1D dq, exact for isotropic surfaces\n"
    "stored energy (Eq. 8)              U_el/(A_app E*) = (1/8) int q C1D dq\n"
    "true area (Eq. 9)                  A_true/A_app = 1 + sqrt(pi)/2 h' exp(1/h'^2) erfc(1/h')\n"
    "full-contact balance (Eq. 7)       W_app = W_int r - gamma_1 (r - 1) - U_el/A_app, r = A_true/A_app\n"
    "Persson-Tosatti balance (Eq. S13)  W_app = W_int (1 + h'^2/2) - U_el/A_app, for comparison\n"
    "loading (Eq. 1)                    a^3 = 3R/(4E*) (F + 3 pi R W + sqrt(6 pi R W F + (3 pi R W)^2))\n"
    "true-area loss (Eq. 10)            E_loss = W_int A_true, A_true = r pi a_max^2\n"
    "\n"
    "Equation numbers: [D19] Dalvi et al., PNAS 116 (2019) 25484.\n"
    "[J17] Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001.\n";

struct Arguments {
    Common common;
    RunArguments run;
    std::string file;
    std::string output;
    bool dry_run = false;
    bool no_figures = false;
    bool all = false;
    bool next = false;
    std::string target = "W_int";
    std::string documentation;
};

void show_failures(const study::StudyResult& result) {
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) print_message(fmt::format("surface {}: {}", surface.name, surface.error));
        if (!surface.likelihood_error.empty())
            print_message(fmt::format("surface {}: {}; its results are averages over its measurements", surface.name,
                                      surface.likelihood_error));
        for (const auto& m : surface.measurements)
            if (m.failed()) print_message(fmt::format("surface {}: {}", surface.name, m.error));
    }
    for (const auto& e : result.experiments)
        if (e.failed()) print_message(e.error);
    for (const auto& alert : result.alerts_of_failed_parts())
        print_message(fmt::format("{}: {}", alert.subject, alert.message));
}

/// Prints the results and their folder.
void print_result(const study::StudyResult& result, const std::string& report, bool all) {
    const auto places = fmt::format("Results: {}\nReport:  {}\n", result.study.output, report);
    constexpr std::size_t lines_of_places = 2;
    const auto size = output_size();
    print((all ? output::summary(result, size.width) : output::screen(result, size, lines_of_places)) + places);
}

study::Study study_of(const Arguments& arguments) {
    if (arguments.file.empty()) throw InvalidArgument("no study; expected a TOML file, see docs/guides/study.md");
    auto study = study::read_study(arguments.file, mapping_folder());
    show(study.alerts);
    if (!arguments.output.empty()) study.output = arguments.output;
    return study;
}

/// Prints missing metadata of the study file, with line numbers.
void print_gaps(const std::vector<study::StudyGap>& gaps, const std::string& file) {
    if (!gaps.empty()) print("\nMissing\n");
    for (const auto& gap : gaps)
        print(one_line(fmt::format("  {}:{}: {}: {}", file, gap.line, gap.item, gap.message)) + "\n");
}

void print_plan(const answers::StudyPlan& plan, const std::string& file) {
    for (const auto& step : plan.steps)
        print(fmt::format("{:<6} {:<12} {}\n", answers::state_of(step), step.stage,
                          step.error.empty() ? step.item : step.error));
    print(fmt::format("{} steps: {} to do, {} kept from earlier runs, {} will fail; folder of the results: {}\n",
                      plan.steps.size(), plan.count("to do"), plan.count("kept"), plan.count("fails"), plan.output));
    print_gaps(plan.missing, file);
}

/// Prints the steps of a run, the results that the store contains, and missing metadata.
ExitCode show_plan(const Arguments& arguments) {
    const auto study = study_of(arguments);
    const auto store = arguments.run.store();
    study::RunOptions options;
    options.threads = arguments.common.workers();
    options.store = &store;
    const auto plan = answers::plan_of(study, options);
    if (arguments.common.json) print_json(output::described(plan));
    else print_plan(plan, arguments.file);
    return plan.count("fails") == 0 ? ExitCode::done : ExitCode::some_failed;
}

/// Draws every figure of a study; returns how many failed.
int draw_figures(const std::vector<study_figures::StudyFigure>& figures, const study::Study& study,
                 output::ResultFolder& results, const Arguments& arguments, const cache::Store& store,
                 ProgressDisplay& display) {
    constexpr double share_of_figures = 0.2;
    const auto before = display.last();
    const auto drawable =
        std::count_if(figures.begin(), figures.end(), [](const auto& figure) { return figure.drawable(); });
    auto step = before;
    step.total += static_cast<std::size_t>(drawable);
    step.stage = "figure";
    study_figures::WriteOptions options;
    options.folder = (std::filesystem::path(study.output) / "figures").string();
    options.path_of = [&results](const std::string& file) { return results.claim("figures/" + file); };
    options.study = study.path;
    options.threads = arguments.common.workers();
    options.store = &store;
    options.cancelled = &interruption();
    options.progress = [&](const std::string& name) {
        step.item = name;
        ++step.done;
        const double drawn = static_cast<double>(step.done - before.done) / static_cast<double>(drawable);
        step.share = 1.0 - share_of_figures * (1.0 - drawn);
        step.computed_share = (1.0 - share_of_figures) * before.computed_share + share_of_figures * drawn;
        display.show(step);
    };
    int failed = 0;
    for (const auto& figure : study_figures::write_figures(figures, options)) {
        if (figure.error.empty()) continue;
        for (const auto& ending : options.endings)
            if (const auto file = figure.name + "." + ending;
                std::find(figure.files.begin(), figure.files.end(), file) == figure.files.end())
                results.drop("figures/" + file);
        display.finish();
        // one missing program is the reason for all failures
        if (failed++ == 0) print_message(fmt::format("figure {}: {}", figure.name, figure.error));
    }
    if (failed > 1)
        print_message(fmt::format(
            "{} more figures have missing files; their numbers are in the CSV files and in report.html", failed - 1));
    return failed;
}

/// The command that repeats the results, without options that do not change them.
std::string command_of(const Arguments& arguments) {
    return "setae study " + shell_word(arguments.file) +
           (arguments.output.empty() ? "" : " --output " + shell_word(arguments.output));
}

ExitCode run_and_write(const Arguments& arguments, const cache::Store& store, ProgressDisplay& display) {
    const auto time = answers::time_of_run();
    const auto study = study_of(arguments);
    output::ResultFolder results(study);
    const auto result = study::run_study(study, run_options(arguments.common.workers(), store, display));
    study_figures::GalleryOptions gallery{.threads = arguments.common.workers()};
    if (arguments.no_figures) gallery.max_of_a_kind = study_figures::max_of_a_kind_in_reports;
    const auto figures = study_figures::study_figures(result, gallery);
    results.begin();
    const int failed_figures =
        arguments.no_figures ? 0 : draw_figures(figures, result.study, results, arguments, store, display);
    display.finish();
    show_failures(result);
    output::write_results(result, results);
    const auto report = results.claim("report.html");
    bytes::write_whole_file(report, report::as_html(result, figures, {command_of(arguments), time}));
    results.finish();
    if (arguments.common.json) {
        output::write_json(result, [](std::string_view piece) { print(std::string(piece)); });
    } else {
        print_result(result, report, arguments.all);
    }
    report_traffic(store);
    const bool empty = result.study.surfaces.empty() && result.study.experiments.empty();
    if (empty) print_message("the study contains no surface and no experiment");
    if (result.successes() == 0 && (result.failures() > 0 || empty)) return ExitCode::nothing_done;
    return result.failures() + failed_figures == 0 ? ExitCode::done : ExitCode::some_failed;
}

/// Runs the study without writing files and passes the result to `show`.
ExitCode run_and_show(const Arguments& arguments, const std::function<void(const study::StudyResult&)>& show) {
    const auto store = arguments.run.store();
    ProgressDisplay display(arguments.run.progress_mode());
    return until_interrupted(store, display, [&] {
        const auto result =
            study::run_study(study_of(arguments), run_options(arguments.common.workers(), store, display));
        display.finish();
        show(result);
        return result.failures() == 0 ? ExitCode::done : ExitCode::some_failed;
    });
}

/// Prints further measurements, sorted by their effect on a standard error.
ExitCode show_next(const Arguments& arguments) {
    return run_and_show(arguments, [&](const study::StudyResult& result) {
        const output::NextMeasurements next{arguments.target, study::next_measurements(result, arguments.target)};
        if (arguments.common.json) print_json(output::described(next));
        else print(tables::as_text_within(output::next_table(next), output_size().width));
    });
}

ExitCode run(const Arguments& arguments) {
    if (!arguments.documentation.empty()) {
        write_pages(arguments.documentation, study_pages());
        return ExitCode::done;
    }
    if (arguments.dry_run) return show_plan(arguments);
    if (arguments.next) return show_next(arguments);
    const auto store = arguments.run.store();
    ProgressDisplay display(arguments.run.progress_mode());
    return until_interrupted(store, display, [&] { return run_and_write(arguments, store, display); });
}

/// Prints formulas and sources; with a study also the error budget of each number.
ExitCode explain(const Arguments& arguments) {
    print(explanation);
    if (arguments.file.empty()) return ExitCode::done;
    if (!std::filesystem::exists(arguments.file)) {
        print_message(fmt::format("{}: no such file; only formulas are printed", arguments.file));
        return ExitCode::done;
    }
    return run_and_show(arguments, [](const study::StudyResult& result) {
        print("\n" + output::budget_text(result, output_size().width));
    });
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("file", arguments->file, "TOML file of the study; a file with the name init is given as ./init")
        .of_inputs();
    options.output("--output", arguments->output, "folder of the results; default: next to the study");
    options.flag("--all", arguments->all, "every table and warning instead of one screen").in(OptionGroup::output);
    options.flag("--no-figures", arguments->no_figures, "no files of figures; the report contains its own figures")
        .in(OptionGroup::output);
    arguments->run.add_to(options);
    options.flag("--dry-run", arguments->dry_run,
                 "list of the steps, of results kept from earlier runs, and of missing metadata; nothing is computed");
    options.flag(
        "--next", arguments->next,
        "list of single further measurements by the standard error that each would leave, most effective first; nothing is "
        "written; [costs] of the study states hours");
    options
        .add(
            "--target", arguments->target,
            "result whose standard error --next reduces: W_int, a pair such as \"E07 on rough\", or the difference of two "
            "balances in W_int by their equation numbers, such as "
            "\"(7) - (10)\"; default: W_int")
        .value_named("RESULT");
    options
        .add("--documentation", arguments->documentation,
             "folder for the pages on keys, warnings and figures of studies")
        .in(OptionGroup::advanced);
    options.example("setae study study.toml --dry-run", "list of the steps, with the steps that will fail");
    options.example("setae study study.toml", "tables, figures and a report");
    options.example("setae study study.toml --next",
                    "further measurements by their effect on the standard error of W_int");
    options.example("setae study study.toml --explain",
                    "formulas, and contributions of the inputs to each standard error");
    arguments->common.add_to(options);
    return [arguments] {
        arguments->common.apply();
        show_every_warning(arguments->all);
        return arguments->common.explain ? explain(*arguments) : run(*arguments);
    };
}

}  // namespace setae::cli::study_command
