// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr_models.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/experiment/branch_samples.hpp"
#include "setae/workflow/fit_json.hpp"
#include "setae/workflow/tidy_table.hpp"

namespace setae::cli {
namespace {

using experiment::ContactModel;
using experiment::LoopBranch;

LoopBranch branch_named(const std::string& name) { return name == "loading" ? LoopBranch::loading : LoopBranch::unloading; }

experiment::ModelFitOptions options_of(const ModelArguments& arguments, ContactModel model) {
    experiment::ModelFitOptions options{.model = model};
    options.errors = arguments.errors == "effective_variance" ? experiment::FitErrors::effective_variance
                     : arguments.errors == "force_only"       ? experiment::FitErrors::force_only
                                                              : experiment::FitErrors::orthogonal_distance;
    if (!arguments.contact_point.empty()) options.contact_point = parse_quantity(arguments.contact_point, dimension::length);
    if (!arguments.cohesive_stress.empty() && model == ContactModel::maugis_dugdale)
        options.cohesive_stress = parse_quantity(arguments.cohesive_stress, dimension::pressure);
    return options;
}

/// Does what a verb was asked for; what the data do not allow becomes a sentence.
template <class Computation>
void attempt(LoopModels& models, const std::string& what, const Computation& computation) {
    try {
        computation();
    } catch (const Error& error) {
        models.failures.push_back(what + ": " + error.what());
    }
}

experiment::CrackSpeedFit crack_speed_of(const AnalysedLoop& loop, const ModelArguments& arguments) {
    const auto samples = experiment::branch_samples(loop.analysis, LoopBranch::unloading, loop.options);
    if (samples.time.size() == 0) throw UndefinedDataError("the record has no time");
    const auto& rates = loop.analysis.unloading->energy_release_rate;
    if (!rates.radius_measured) throw UndefinedDataError("the contact radius was not measured: its implied value has no speed of its own");
    auto points = experiment::crack_speed_points(samples.time, rates.contact_radius, rates.energy_release_rate);
    return experiment::fit_crack_speed(points, {.exponent = arguments.exponent});
}

std::string cell(const Estimate& estimate, double factor) { return fmt::format("{:.4g} ± {:.2g}", factor * estimate.value, factor * estimate.standard_error); }
std::string cell(const experiment::Outcome<Estimate>& estimate, double factor) { return estimate ? cell(*estimate, factor) : "–"; }

void add_row(workflow::TidyTable& table, const experiment::ModelFit& fit, double akaike_difference) {
    table.rows.push_back({to_string(fit.model), cell(fit.contact_modulus, 1e-6), cell(fit.work_of_adhesion, 1e3), cell(fit.transition_parameter, 1.0),
                          fmt::format("{:.3g}", fit.chi2_reduced), fmt::format("{}", fit.n), akaike_difference});
}

}  // namespace

void ModelArguments::add_to(CLI::App& verb) {
    verb.add_option("--model", models, "also fit hertz, dmt, jkr, maugis_dugdale, transition, layer, large_strain; all compares them");
    verb.add_option("--branch", branch, "of --model, --profile and --share")->check(CLI::IsMember({"loading", "unloading"}))->capture_default_str();
    verb.add_option("--errors", errors, "of --model and --share: orthogonal_distance, effective_variance, force_only")
        ->check(CLI::IsMember({"effective_variance", "orthogonal_distance", "force_only"}))->capture_default_str();
    verb.add_option("--model-contact-point", contact_point, "held in --model, such as \"1.2 um\"; default: fitted");
    verb.add_option("--cohesive-stress", cohesive_stress, "held in maugis_dugdale, such as \"5 MPa\"; default: fitted");
    verb.add_flag("--profile", profile, "intervals of E* and W by profile likelihood");
    verb.add_flag("--crack-speed", crack_speed, "fit G(v) = G0 (1 + (v/v0)^n) to the receding edge");
    verb.add_option("--exponent", exponent, "n held in --crack-speed");
    verb.add_option("--share", shared, "one fit of all loops that share modulus, work, or both")->check(CLI::IsMember({"modulus", "work"}));
}

LoopModels models_of(const AnalysedLoop& loop, const ModelArguments& arguments) {
    LoopModels models;
    const auto samples = [&] { return experiment::branch_samples(loop.analysis, branch_named(arguments.branch), loop.options).data; };
    for (const auto& name : arguments.models) {
        attempt(models, name, [&] {
            if (name == "all") models.comparison = experiment::compare_models(samples(), loop.bodies, options_of(arguments, ContactModel::jkr));
            else models.fits.push_back(experiment::fit_model(samples(), loop.bodies, options_of(arguments, experiment::model_named(name))));
        });
    }
    if (arguments.profile)
        attempt(models, "profile likelihood", [&] {
            const auto data = samples();
            using experiment::ProfiledFit;
            const auto fit = data.contact_radius.size() == 0 ? ProfiledFit::force_displacement : data.displacement.size() == 0 ? ProfiledFit::effective_variance : ProfiledFit::joint;
            models.profile = experiment::profile_likelihood(data, loop.bodies, {.fit = fit});
        });
    if (arguments.crack_speed) attempt(models, "crack speed", [&] { models.crack_speed = crack_speed_of(loop, arguments); });
    return models;
}

void print_models(const LoopModels& models) {
    std::string text, reasons;
    workflow::TidyTable table{"", {"model", "E* [MPa]", "W [mJ/m²]", "λ", "χ²_red", "n", "ΔAICc"}, {}};
    for (const auto& fit : models.fits) add_row(table, fit, undefined);
    if (models.comparison)
        for (const auto& model : models.comparison->models)
            if (model.fit) add_row(table, *model.fit, model.akaike_difference);
            else reasons += fmt::format("  {}: {}\n", to_string(model.model), model.fit.reason);
    if (!table.rows.empty()) text += workflow::as_text(table);
    text += reasons;
    for (const auto& fit : models.fits) {
        for (const auto& sentence : fit.undetermined) text += "  " + sentence + '\n';
        if (fit.verdict) text += "  " + fit.verdict->sentence + '\n';
    }
    if (models.comparison) text += "  " + models.comparison->sentence + '\n';
    const auto interval = [](const Estimate& e, double factor, const char* unit) {
        return e.interval ? fmt::format("{:.4g} … {:.4g} {}", factor * e.interval->lower, factor * e.interval->upper, unit) : std::string("open");
    };
    if (models.profile)
        text += fmt::format("  profile likelihood, 95 %     E* {}, W {} ({})\n", interval(models.profile->contact_modulus.estimate, 1e-6, "MPa"),
                            interval(models.profile->work_of_adhesion.estimate, 1e3, "mJ/m²"), models.profile->fit.method);
    if (models.crack_speed)
        text += fmt::format("  G(v) = G0 (1 + (v/v0)^n)     G0 {} mJ/m², v0 {} µm/s, n {}; {} points, speeds over a factor {:.3g}\n", cell(models.crack_speed->threshold, 1e3),
                            cell(models.crack_speed->reference_speed, 1e6), cell(models.crack_speed->exponent, 1.0), models.crack_speed->n, models.crack_speed->speed_ratio);
    for (const auto& failure : models.failures) text += "  " + failure + '\n';
    print(text);
}

workflow::Json json_of(const LoopModels& models) {
    workflow::Json json = workflow::Json::object();
    if (!models.fits.empty()) {
        json["fits"] = workflow::Json::array();
        for (const auto& fit : models.fits) json["fits"].push_back(workflow::to_json(fit));
    }
    if (models.comparison) json["comparison"] = workflow::to_json(*models.comparison);
    if (models.profile) json["profile_likelihood"] = workflow::to_json(*models.profile);
    if (models.crack_speed) json["crack_speed"] = workflow::to_json(*models.crack_speed);
    if (!models.failures.empty()) json["failures"] = models.failures;
    return json;
}

void SharedFit::add(const AnalysedLoop& loop) {
    try {
        branches_.push_back({.name = loop.file, .data = experiment::branch_samples(loop.analysis, branch_named(arguments_.branch), loop.options).data, .bodies = loop.bodies});
    } catch (const UndefinedDataError& error) {
        complain(fmt::format("{}: not in the shared fit: {}", loop.file, error.what()));
    }
}

experiment::GlobalFit SharedFit::fit() const {
    if (branches_.size() < 2) throw InvalidArgument(fmt::format("--share: {} loops to share anything, expected at least 2", branches_.size()));
    const auto shares = [&](const char* what) { return std::find(arguments_.shared.begin(), arguments_.shared.end(), what) != arguments_.shared.end(); };
    const auto model = arguments_.models.size() == 1 && arguments_.models.front() != "all" ? experiment::model_named(arguments_.models.front()) : ContactModel::jkr;
    return experiment::fit_globally(branches_, {.share_contact_modulus = shares("modulus"), .share_work_of_adhesion = shares("work"), .fit = options_of(arguments_, model)});
}

void print_shared(const experiment::GlobalFit& fit) {
    workflow::TidyTable table{fmt::format("{} loops in one fit, {}", fit.branches.size(), to_string(fit.options.fit.model)),
                              {"loop", "E* [MPa]", "W [mJ/m²]", "E* alone [MPa]", "W alone [mJ/m²]", "n"}, {}};
    for (const auto& branch : fit.branches)
        table.rows.push_back({branch.name, cell(branch.contact_modulus, 1e-6), cell(branch.work_of_adhesion, 1e3), cell(branch.separate.contact_modulus, 1e-6),
                              cell(branch.separate.work_of_adhesion, 1e3), fmt::format("{}", branch.n)});
    print(workflow::as_text(table) + fmt::format("  do they share it? F = {:.3g}, p = {:.2g} (small: they differ)\n", fit.sharing.f_ratio, fit.sharing.p_value));
}

}  // namespace setae::cli
