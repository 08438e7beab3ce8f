// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/experiment/analysis.hpp"
#include "setae/workflow/loop_file.hpp"
#include "setae/workflow/tidy_table.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

constexpr const char* explanation =
    "radius_force        a^3 = 3R/(4E*) (F + 3 pi R W + sqrt(6 pi R W F + (3 pi R W)^2))       [D19] (1)\n"
    "linear_form         F/sqrt(6 pi a^3) = K a^(3/2)/(sqrt(6 pi) R) - sqrt(K W), K = 4E*/3\n"
    "force_displacement  delta = a^2/R - sqrt(2 pi a W/E*) + delta_0, a(F) by (1)\n"
    "pointwise           F = 2 a E* (delta - delta_0 - a^2/(3R)), free of W\n"
    "pull_off            W = 2|F_po|/(3 pi R), fixed load                                      [D19] (S1)\n"
    "retraction          (1) on the last points before pull-off, E* of loading                 [D19] (S2)\n"
    "loop                E_loss = closed integral of F d(delta), baseline and drift removed\n";

struct Arguments {
    Common common;
    std::vector<std::string> files;
    std::string map, radius, lens_height, layer_thickness, counter_modulus, machine_stiffness;
    double poisson_ratio = 0.5, counter_poisson_ratio = 0.0;
    long samples_dropped = 3;
    bool unweighted = false, modulus_free = false, no_drift = false, whole_retraction = false;
};

experiment::LensAndCounterBody bodies_of(const Arguments& a) {
    experiment::LensAndCounterBody bodies;
    if (a.radius.empty()) throw InvalidArgument("missing --radius, the radius of the sphere, such as --radius \"7.5 um\"");
    bodies.radius = parse_quantity(a.radius, dimension::length);
    bodies.lens_poisson_ratio = a.poisson_ratio;
    bodies.counter_youngs_modulus = a.counter_modulus.empty() ? std::numeric_limits<double>::infinity() : parse_quantity(a.counter_modulus, dimension::pressure);
    bodies.counter_poisson_ratio = a.counter_poisson_ratio;
    if (!a.lens_height.empty()) bodies.lens_height = parse_quantity(a.lens_height, dimension::length);
    if (!a.layer_thickness.empty()) bodies.layer_thickness = parse_quantity(a.layer_thickness, dimension::length);
    return bodies;
}

experiment::AnalysisOptions options_of(const Arguments& a) {
    experiment::AnalysisOptions options;
    options.samples_dropped = a.samples_dropped;
    options.effective_variance = !a.unweighted;
    options.force_drift = !a.no_drift;
    options.leave_pinned_out = !a.whole_retraction;
    options.retraction_modulus_free = a.modulus_free;
    if (!a.machine_stiffness.empty()) options.machine_stiffness = parse_quantity(a.machine_stiffness, dimension::stiffness);
    return options;
}

void add_branch(workflow::TidyTable& table, const char* branch, const experiment::BranchAnalysis& analysis) {
    const auto add = [&](const experiment::Outcome<experiment::JkrFit>& fit) {
        if (!fit) return;
        const auto cell = [](const Estimate& v, double factor) { return fmt::format("{:.4g} ± {:.2g}", factor * v.value, factor * v.standard_error); };
        table.rows.push_back({branch, fit->method, cell(fit->contact_modulus, 1e-6), cell(fit->youngs_modulus, 1e-6), cell(fit->work_of_adhesion, 1e3),
                              fmt::format("{:.3f}", fit->correlation), fmt::format("{:.3g}", fit->chi2_reduced), fmt::format("{}", fit->n),
                              fmt::format("{:.3g} {}", fit->rms_residual, fit->residual_unit)});
    };
    add(analysis.radius_force);
    add(analysis.radius_force_effective_variance);
    add(analysis.linear_form);
    add(analysis.force_displacement);
}

void print_loop(const std::string& file, const experiment::LoopAnalysis& a) {
    workflow::TidyTable table{file, {"branch", "fit", "E* [MPa]", "E [MPa]", "W [mJ/m²]", "correlation", "χ²_red", "n", "rms residual"}, {}};
    add_branch(table, "loading", a.loading);
    if (a.unloading) add_branch(table, "unloading", *a.unloading);
    std::string text = workflow::as_text(table);
    text += fmt::format("  range: {}\n  samples dropped after jump-in → W:", a.loading.range.name);
    for (const auto& s : a.loading.sensitivity) text += s.fit ? fmt::format("  {} → {:.1f} mJ/m²", s.dropped, 1e3 * s.fit->work_of_adhesion.value) : "";
    text += '\n';
    const auto line = [&](const char* what, const std::string& value) { text += fmt::format("  {:<28} {}\n", what, value); };
    const auto value = [](const Estimate& v, const char* unit) { return format_value(v.value, unit) + " ± " + format_value(v.standard_error, unit, 2); };
    line("pull-off force", a.pull_off ? value(a.pull_off->force, "N") : a.pull_off.reason);
    if (a.pull_off) line("W of pull-off (S1)", value(a.pull_off->work_of_adhesion, "J/m2"));
    line("W of retraction (S2)", a.retraction ? value(a.retraction->work_of_adhesion, "J/m2") : a.retraction.reason);
    line("loop energy", a.loop ? value(a.loop->estimate(), "J") : a.loop.reason);
    line("smooth sphere's own loss", format_value(a.context.ideal_smooth_sphere_loss, "J"));
    line("largest contact radius", format_value(a.context.largest_contact_radius, "m") + (a.context.radius_measured ? "" : " (implied)"));
    line("cycles", fmt::format("{}", a.cycles.size()));
    print(text);
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty()) throw InvalidArgument("no file; expected at least one loop");
    const auto bodies = bodies_of(arguments);
    const auto options = options_of(arguments);
    const auto mapping = arguments.map.empty() ? std::nullopt : std::optional(arguments.map);
    workflow::Json list = workflow::Json::array();
    const auto code = for_each_item(arguments.files, [&](const std::string& file) {
        const auto analysis = workflow::analyse_loop_file(file, mapping, bodies, options);
        if (arguments.common.json) {
            auto json = workflow::to_json(analysis);
            json["file"] = file;
            list.push_back(std::move(json));
        } else {
            print_loop(file, analysis);
            show(analysis.alerts);
        }
    });
    if (arguments.common.json && !list.empty()) print_json(arguments.files.size() == 1 ? list.front() : list);
    return code;
}

}  // namespace

void add_jkr(CLI::App& program, Action& action) {
    auto arguments = std::make_shared<Arguments>();
    auto* group = program.add_subcommand("jkr", "contact experiments with a soft or hard sphere");
    group->require_subcommand(1);
    add_jkr_summary(*group, action);
    auto* verb = group->add_subcommand("fit", "fit JKR to loops of force, displacement and contact radius");
    verb->add_option("files", arguments->files, "loops: tables with units in the header, or read through --map");
    verb->add_option("--map", arguments->map, "mapping file (TOML) that names the columns of a foreign table");
    verb->add_option("--radius", arguments->radius, "radius of the sphere, such as \"7.5 um\"");
    verb->add_option("--nu,--poisson-ratio", arguments->poisson_ratio, "Poisson ratio of the soft body");
    verb->add_option("--counter-E", arguments->counter_modulus, "Young's modulus of the counter-body; default rigid");
    verb->add_option("--counter-nu", arguments->counter_poisson_ratio, "its Poisson ratio");
    verb->add_option("--lens-height", arguments->lens_height, "height of the soft lens above its mount");
    verb->add_option("--layer-thickness", arguments->layer_thickness, "thickness of the soft layer on a rigid base");
    verb->add_option("--machine-stiffness", arguments->machine_stiffness, "where displacement is the stage's, such as \"30 N/m\"");
    verb->add_option("--samples-dropped", arguments->samples_dropped, "samples left out after the jump into contact")->check(CLI::Range(0L, 1000000L));
    verb->add_flag("--unweighted", arguments->unweighted, "ordinary least squares in radius or depth, errors of force left out");
    verb->add_flag("--no-drift", arguments->no_drift, "one zero of force, from free flight before contact");
    verb->add_flag("--whole-retraction", arguments->whole_retraction, "fit the retraction from the largest force, its pinned stretch included");
    verb->add_flag("--retraction-modulus-free", arguments->modulus_free, "fit E* in (S2) too");
    on_named(*verb, action, arguments, explanation, run);
}

}  // namespace setae::cli
