// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jkr/jkr_curve.hpp"
#include "jkr/jkr_models.hpp"
#include "jkr/loop_arguments.hpp"
#include "jkr/loop_figures.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/command_line.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/curve_fields.hpp"
#include "setae/answers/loop_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/loop_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/file_names.hpp"
#include "setae/output/force_map_output.hpp"
#include "setae/output/loop_answer.hpp"
#include "setae/output/loop_tables.hpp"
#include "setae/study_figures/loop_figures.hpp"

namespace setae::cli::jkr_fit_command {
namespace {

constexpr const char* explanation =
    "The command fits E* and W of JKR to both branches of a loop and computes the energy loss.\n"
    "\n"
    "radius_force        a^3 = 3R/(4E*) (F + 3 pi R W + sqrt(6 pi R W F + (3 pi R W)^2)); (Eq. 1)\n"
    "linear_form         F/sqrt(6 pi a^3) = K a^(3/2)/(sqrt(6 pi) R) - sqrt(K W), K = 4E*/3\n"
    "force_displacement  delta = a^2/R - sqrt(2 pi a W/E*) + delta_0, with a(F) of Eq. 1\n"
    "pointwise           F = 2 a E* (delta - delta_0 - a^2/(3R)), independent of W\n"
    "pull_off            W_ret at pull-off, 2|F_po|/(3 pi R), for fixed load (Eq. S1)\n"
    "retraction          W_ret at pull-off from the last points, with E* of loading (Eq. S2)\n"
    "along retraction    W_ret(a) = W_po + s (a - a_po), from G(a) of the edge on retraction, and the loss of such a loop\n"
    "loop                E_loss = closed integral of F d(delta), baseline and drift removed\n"
    "\n"
    "Equation numbers: Dalvi et al., PNAS 116 (2019) 25484 [D19].\n";

struct Arguments {
    Common common;
    LoopAnalysisRequest request;
    answers::LoopModelsRequest models;
    answers::CurveRequest curve;
    std::string tidy, figures, output;
    bool full = false;  ///< every fit and warning of every loop
    FigureOption figure;
};

/// The fits of a branch, one row per fit.
tables::TidyTable branch_table(const char* branch, const loops::BranchAnalysis& analysis) {
    tables::TidyTable table{branch, {"fit", "E* [MPa]", "W [mJ/m²]", "χ²_red", "n", "rms residual"}, {}};
    for (const auto& route : loops::fit_routes) {
        const auto& fit = analysis.*route.fit;
        if (!fit) continue;
        table.rows.push_back({fit->method, uncertain_number(fit->contact_modulus, 1e6),
                              uncertain_number(fit->work_of_adhesion, 1e-3), fmt::format("{:.3g}", fit->chi2_reduced),
                              fmt::format("{}", fit->n), format_value(fit->rms_residual, fit->residual_unit, 3)});
    }
    return table;
}

std::string hold_text(const loops::HoldGrowth& hold) {
    std::string text = std::isfinite(hold.duration) ? format_value(hold.duration, "s", 3)
                                                    : fmt::format("{} samples", hold.samples.count());
    const auto add = [&](const char* what, const loops::Change& change, const char* unit) {
        text += fmt::format(", {} {} → {}", what, format_value(change.first.value, unit),
                            format_value(change.last.value, unit));
    };
    if (hold.contact_radius) add("a", *hold.contact_radius, "m");
    else if (hold.displacement) add("δ", *hold.displacement, "m");
    if (hold.work_of_adhesion) add("W", *hold.work_of_adhesion, "J/m2");
    return text;
}

/// "-12.3 ± 0.4 µN from the first sample to the last, a line, removed".
std::string drift_text(const loops::ForceDrift& drift) {
    if (drift.stretches == 0) return "unknown without free flight";
    if (drift.degree == 0) return "not fitted";
    static constexpr const char* curves[] = {"", "a line", "a parabola", "a cubic"};
    return fmt::format("{} from the first sample to the last, {}, removed", format_uncertain(drift.change, "N"),
                       curves[drift.degree]);
}

/// "85 ± 1 mJ/m² at the largest contact, 60 ± 1 at pull-off, …; loss of such a loop 12.3 ± 0.2 nJ".
std::string along_text(const loops::Outcome<loops::WorkAlongRetraction>& along) {
    if (!along) return along.reason;
    return fmt::format(
        "{} at the largest contact, {} at pull-off, slope {}; loss of such a loop {}",
        format_uncertain(along->at_largest_contact, "J/m2"), format_uncertain(along->at_pull_off, "J/m2"),
        format_uncertain(scaled(along->slope, 1e-6), "J/m2") + " per µm", format_uncertain(along->energy_loss, "J"));
}

void print_loop(const std::string& file, const loops::LoopAnalysis& a) {
    const auto width = output_size().width;
    std::string text = wrapped(file + ": " + output::answer(a), width, 2) + "\n" +
                       tables::as_text_within(branch_table("loading", a.loading), width);
    if (a.unloading) text += tables::as_text_within(branch_table("unloading", *a.unloading), width);
    text += fmt::format("  range: {}\n", a.loading.range.name);
    std::string dropped = "samples dropped after jump-in → W:";
    for (const auto& s : a.loading.sensitivity)
        if (s.fit)
            dropped += fmt::format("{} {} → {:.1f} mJ/m²", dropped.ends_with(':') ? "" : ",", s.dropped,
                                   1e3 * s.fit->work_of_adhesion.value);
    text += "  " + wrapped_from(4, dropped, width) + "\n";
    const auto line = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<28} {}\n", what, wrapped_from(31, value, width));
    };
    const auto value = [](const Estimate& v, const char* unit) { return format_uncertain(v, unit); };
    if (a.contact_points) {
        const auto& points = *a.contact_points;
        tables::TidyTable contact_points{
            "", {"  contact point by", "minus the one used [nm]", "±", "E* [MPa]", "W [mJ/m²]"}, {}};
        for (const auto& estimate : points.estimates) {
            if (!estimate.contact_point) continue;
            const auto& fit = estimate.fit;
            contact_points.rows.push_back(
                {"  " + loops::contact_point_name(estimate.method),
                 fmt::format("{:.4g}", 1e9 * (estimate.contact_point->value - points.contact_point.value)),
                 fmt::format("{:.2g}", 1e9 * estimate.contact_point->standard_error),
                 fit ? fmt::format("{:.4g}", 1e-6 * fit->contact_modulus.value) : "–",
                 fit ? fmt::format("{:.4g}", 1e3 * fit->work_of_adhesion.value) : "–"});
        }
        text += tables::as_text_within(contact_points, width);
        line("spread of contact points", fmt::format("{} ({:.2g} % of the penetration), dW/dδ0 {:.3g} mJ/m² per nm",
                                                     format_value(points.spread, "m"), 100.0 * points.spread_share,
                                                     1e-6 * points.work_by_contact_point));
    }
    const auto& primary = a.loading.primary();
    line("E of loading", format_uncertain(primary.youngs_modulus, "Pa"));
    line("correlation of E* and W", fmt::format("{:.3f}", primary.correlation));
    line("drift of the force", drift_text(a.force_zero.drift));
    line("pull-off force", a.pull_off ? value(a.pull_off->force, "N") : a.pull_off.reason);
    if (a.pull_off) line("W_ret at pull-off (Eq. S1)", value(a.pull_off->work_of_adhesion, "J/m2"));
    line("W_ret at pull-off (Eq. S2)",
         a.retraction ? value(a.retraction->work_of_adhesion, "J/m2") : a.retraction.reason);
    line("W_ret along retraction", along_text(a.work_along_retraction));
    line("loop energy", a.loop ? value(a.loop->estimate(), "J") : a.loop.reason);
    line("loss of a smooth sphere", format_value(a.context.ideal_smooth_sphere_loss, "J"));
    if (a.bulk)
        line("loss in the relaxing bulk",
             fmt::format("{}; force corrected by up to {}", format_value(a.bulk->energy_loss, "J"),
                         format_value(a.bulk->largest_force, "N")));
    if (a.hold) line("hold", hold_text(*a.hold));
    line("largest contact radius",
         format_value(a.context.largest_contact_radius, "m") + (a.context.radius_measured ? "" : " (implied)"));
    if (!a.context.applicable_model.empty()) line("model", a.context.applicable_model);
    line("cycles", fmt::format("{}", a.cycles.size()));
    print(text);
}

study_figures::DrawnLoop drawn_loop(const AnalysedLoop& loop) {
    return {.name = figure_name(loop.file), .analysis = loop.analysis, .bodies = loop.bodies, .options = loop.options};
}

/// The figures of every loop, and one figure of all loops.
class FigureFolder {
public:
    FigureFolder(const Arguments& arguments) : arguments_(arguments) {}

    void add(const AnalysedLoop& loop) {
        const auto drawn = drawn_loop(loop);
        for (auto& figure : study_figures::loop_figures(drawn, command_line())) figures_.push_back(std::move(figure));
        try {
            scans_.push_back({drawn.name, loops::scan_ranges(loop.analysis, loop.bodies, loop.options)});
        } catch (const UndefinedDataError& error) {
            print_message(fmt::format("{}: no figure of ranges: {}", loop.file, error.what()));
        }
    }

    void write() {
        figures_.push_back(study_figures::range_figure(scans_, command_line()));
        write_loop_figures(figures_, arguments_.figures, arguments_.common.workers());
    }

private:
    const Arguments& arguments_;
    std::vector<study_figures::StudyFigure> figures_;
    std::vector<study_figures::NamedScan> scans_;
};

/// Fits all curves of a file with several curves.
void fit_curves_of(const std::string& file, const std::string& name, const Arguments& arguments, output::Json& list) {
    const auto map = answers::fit_map(file, arguments.request.loops, arguments.request.bodies, arguments.curve,
                                      arguments.common.workers());
    const auto written =
        arguments.output.empty() ? std::vector<std::string>{} : output::write_force_map(map, arguments.output, name);
    if (arguments.common.json) {
        list.push_back(output::described(map));
        return;
    }
    print_map(map);
    for (const auto& path : written) print(path + " written\n");
    if (written.empty()) print("nothing written; give -o FOLDER for a table of the curves and maps\n");
}

/// Fits the force curves among the files.
ExitCode fit_curves(const Arguments& arguments, const std::vector<std::string>& files, output::Json& list) {
    std::vector<std::string> stems;
    for (const auto& file : files) stems.push_back(figure_name(file));
    const auto names = output::file_names(stems);
    std::size_t at = 0;
    return for_each_item(files, [&](const std::string& file) {
        const auto& name = names[at++];
        if (arguments.curve.concerns_map(file, arguments.request.loops)) {
            fit_curves_of(file, name, arguments, list);
            return;
        }
        const auto analysis =
            answers::fit_curve(file, arguments.request.loops, arguments.request.bodies, arguments.curve);
        if (arguments.common.json) list.push_back(output::described(answers::FittedCurve{file, &analysis}));
        else print_curve(file, analysis);
    });
}

/// Adds the branch of a loop to a shared fit, if the loop has this branch.
void add_to_shared_fit(const AnalysedLoop& loop, const study::LoopModelOptions& models,
                       std::vector<loops::GlobalBranch>& shared) {
    try {
        shared.push_back(study::branch_to_share(loop.file, loop.analysis, loop.bodies, loop.options, models));
    } catch (const UndefinedDataError& error) {
        print_message(fmt::format("{}: excluded from the shared fit: {}", loop.file, error.what()));
    }
}

/// Name of the file of a loop; with the folder if several files have this name.
std::string unique_name(const std::vector<std::string>& files, const std::string& file) {
    const auto name = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
    return std::ranges::count(files, name(file), name) == 1 ? name(file) : file;
}

/// All results of a loop; warnings that concern every number come first.
void print_all_results(const AnalysedLoop& loop, const study::LoopModelOptions& models) {
    const auto& alerts = loop.analysis.alerts;
    const auto others = std::find_if_not(alerts.begin(), alerts.end(), study::names_cause);
    show({alerts.begin(), others});
    print_loop(loop.file, loop.analysis);
    if (models.any()) print_models("", answers::models_of(loop, models));
    show({others, alerts.end()});
}

/// Fits the loops among the files, and a shared fit if the options ask for one.
ExitCode fit_loops(const Arguments& arguments, const LoopAnalysisRequest& request, output::Json& list,
                   std::optional<loops::GlobalFit>& global) {
    if (arguments.full) show_every_warning(true);
    auto fits = output::fits_table();
    FigureFolder figures(arguments);
    const auto models = arguments.models.options();
    std::vector<loops::GlobalBranch> shared;
    const auto files = request.loops.expanded();
    const bool in_rows = files.size() > 1 && !arguments.full;
    auto rows = output::loop_rows_table();
    const auto code = for_each_loop(request, arguments.common.workers(), [&](const AnalysedLoop& loop) {
        output::add_fits(fits, output::labels_stated_in(loop.opened.table, loop.file), loop.analysis);
        if (!arguments.figures.empty()) figures.add(loop);
        if (!arguments.output.empty())
            write_figure(file_figures::loop_figure(drawn_loop(loop), arguments.figure.look()), arguments.output,
                         arguments.common.json);
        if (models.shared()) add_to_shared_fit(loop, models, shared);
        if (arguments.common.json) {
            list.push_back(output::described(answers::fitted(loop, models)));
            return;
        }
        output::add_loop_row(rows, unique_name(files, loop.file), loop.analysis);
        if (!in_rows) print_all_results(loop, models);
        else if (models.any()) print_models(loop.file, answers::models_of(loop, models));
    });
    if (code == ExitCode::nothing_done) return code;
    if (!arguments.common.json && in_rows) print(tables::as_text(rows) + "--long prints every fit and warning\n");
    if (models.shared()) global = study::shared_fit(shared, models);
    if (!arguments.figures.empty()) figures.write();
    if (!arguments.tidy.empty()) bytes::write_whole_file(arguments.tidy, tables::as_csv(fits));
    return code;
}

/// -o is the figure of one loop, or the folder of results for files of many force curves.
void check_output(const std::string& output, const std::vector<std::string>& curves,
                  const std::vector<std::string>& loops) {
    if (!file_figures::is_figure_path(output) && loops.empty()) return;
    if (!file_figures::is_figure_path(output))
        throw InvalidArgument(fmt::format(
            "{}: cannot tell the format from the name; expected an ending {}; --tidy OUT.csv writes the fits", output,
            file_figures::figure_endings));
    if (!curves.empty())
        throw InvalidArgument(fmt::format("{}: no figure is drawn of a force curve; leave out -o", curves.front()));
    if (loops.size() > 1)
        throw InvalidArgument(fmt::format("{} loops for one figure {}; draw one figure per loop with --figures FOLDER",
                                          loops.size(), output));
}

/// The fits to loops, and the fit with the parameters that they share.
output::Json shared_json(const loops::GlobalFit& fit, const output::Json& loops) {
    auto json = output::described(answers::SharedLoops{&fit});
    json["loops"] = loops;
    return json;
}

ExitCode run(const Arguments& arguments) {
    output::Json list = output::Json::array();
    auto loops = arguments.request;
    std::vector<std::string> curves;
    loops.loops.files.clear();
    for (const auto& file : arguments.request.loops.expanded())
        (arguments.curve.concerns(file) ? curves : loops.loops.files).push_back(file);
    if (!arguments.output.empty()) check_output(arguments.output, curves, loops.loops.files);
    std::optional<loops::GlobalFit> global;
    std::vector<ExitCode> codes;
    if (!curves.empty()) codes.push_back(fit_curves(arguments, curves, list));
    if (!loops.loops.files.empty()) codes.push_back(fit_loops(arguments, loops, list, global));
    if (arguments.common.json && !list.empty()) {
        const auto results = list.size() == 1 ? list.front() : list;
        print_json(global ? shared_json(*global, results) : results);
    } else if (global) {
        print_shared(*global);
    }
    return std::all_of(codes.begin(), codes.end(), [&](ExitCode code) { return code == codes.front(); })
               ? codes.front()
               : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->request.add_to(options);
    options.ask(arguments->models);
    options.ask(arguments->curve);
    options.output(
        "-o,--output", arguments->output,
        "figure OUT.svg, .pdf or .png of one loop with the fits; for files of many force curves a folder: NAME.csv, one "
        "row per curve, and NAME.gwy, maps of E*, E, W, pull-off and loss");
    arguments->figure.add_to(options);
    options.flag("--long", arguments->full, "every fit and warning of several loops, not one row per loop")
        .in(OptionGroup::output);
    options.output("--tidy", arguments->tidy, "CSV table of every fit of all loops");
    options.output("--figures", arguments->figures,
                   "folder of figures: each loop with fits and residuals, E* and W against the range of the fit");
    options.example("setae jkr fit loop.csv --radius \"1.25 mm\" -o loop.svg",
                    "E* and W of loading, pull-off and loss, with a figure of the fits");
    options.example("setae jkr fit loops --radius \"1.25 mm\" --tidy fits.csv",
                    "one row per loop; table of every fit of every loop");
    options.example("setae jkr fit curve.jpk-force --radius \"20 nm\" --curve-model dmt", "DMT fit of a force curve");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_fit_command
