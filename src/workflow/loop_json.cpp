// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_support.hpp"

namespace setae::workflow {
namespace {

using experiment::JkrFit;

void add_moduli_and_work(Json& json, const JkrFit& fit) {
    const auto counted = [&](Quantity q) {
        q.n = static_cast<int>(fit.n);
        add(json, q);
    };
    counted(quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    counted(quantity("youngs_modulus", "E", fit.youngs_modulus, "Pa"));
    counted(quantity("work_of_adhesion", "W", fit.work_of_adhesion, "J/m2"));
}

Json fit_json(const JkrFit& fit) {
    Json json{{"method", fit.method}, {"converged", fit.converged}};
    add_moduli_and_work(json, fit);
    if (fit.contact_point.value == fit.contact_point.value) add(json, quantity("contact_point", "delta0", fit.contact_point, "m"));
    json["correlation"] = number(fit.correlation);
    json["correlated_samples"] = number(fit.correlated_samples);
    Json covariance = Json::array();
    for (Index i = 0; i < fit.covariance.rows(); ++i) covariance.push_back(numbers(fit.covariance.row(i).array()));
    json["covariance"] = covariance;
    json["n"] = fit.n;
    json["chi_squared_reduced"] = number(fit.chi2_reduced);
    add(json, quantity("rms_residual", "rms", fit.rms_residual, fit.residual_unit));
    json["relative_residual"] = number(fit.relative_residual);
    json["residuals"] = numbers(fit.residuals);
    if (fit.depth_residuals.size() > 0) json["depth_residuals"] = numbers(fit.depth_residuals);
    json["runs"] = {{"runs", fit.runs.runs}, {"above", fit.runs.above}, {"below", fit.runs.below}, {"p_value", number(fit.runs.p_value)}};
    return json;
}

Json pointwise_json(const experiment::PointwiseModulus& fit) {
    Json json;
    add(json, quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    add(json, quantity("youngs_modulus", "E", fit.youngs_modulus, "Pa"));
    add(json, quantity("contact_point", "delta0", fit.contact_point, "m"));
    json["n"] = fit.n;
    json["relative_residual"] = number(fit.relative_residual);
    return json;
}

Json range_json(const experiment::FitRange& range) {
    return {{"name", range.name},
            {"first", range.first},
            {"last", range.last},
            {"n", range.n},
            {"force_first", to_json(quantity("force", "F", range.force_first, "N"))},
            {"force_last", to_json(quantity("force", "F", range.force_last, "N"))}};
}

Json branch_json(const experiment::BranchAnalysis& branch) {
    Json json;
    add_moduli_and_work(json, branch.primary());
    json["method"] = branch.primary().method;
    json["range"] = range_json(branch.range);
    Json fits;
    add_outcome(fits, "radius_force", branch.radius_force, fit_json);
    add_outcome(fits, "radius_force_effective_variance", branch.radius_force_effective_variance, fit_json);
    add_outcome(fits, "linear_form", branch.linear_form, fit_json);
    add_outcome(fits, "force_displacement", branch.force_displacement, fit_json);
    add_outcome(fits, "joint", branch.joint, fit_json);
    add_outcome(fits, "pointwise", branch.pointwise, pointwise_json);
    json["fits"] = fits;
    json["energy_release_rate"] = {{"contact_radius", numbers(branch.energy_release_rate.contact_radius)},
                                   {"contact_radius_unit", "m"},
                                   {"energy_release_rate", numbers(branch.energy_release_rate.energy_release_rate)},
                                   {"standard_error", numbers(branch.energy_release_rate.standard_error)},
                                   {"systematic", numbers(branch.energy_release_rate.systematic)},
                                   {"energy_release_rate_unit", "J/m2"},
                                   {"contact_radius_measured", branch.energy_release_rate.radius_measured}};
    Json sensitivity = Json::array();
    for (const auto& entry : branch.sensitivity) {
        Json row{{"samples_dropped", entry.dropped}};
        if (entry.fit)
            add_moduli_and_work(row, *entry.fit);
        else
            row["reason"] = entry.fit.reason;
        sensitivity.push_back(row);
    }
    json["sensitivity_to_range"] = sensitivity;
    return json;
}

Json pull_off_json(const experiment::PullOff& pull_off) {
    Json json{{"index", pull_off.index}};
    add(json, quantity("force", "F_po", pull_off.force, "N"));
    auto fixed_load = quantity("work_of_adhesion", "W_po", pull_off.work_of_adhesion, "J/m2");
    fixed_load.source = "W = 2|F_po|/(3 pi R), fixed load; [D19] (S1)";
    add(json, fixed_load);
    auto fixed_grips = quantity("work_of_adhesion_fixed_grips", "W_po", pull_off.work_of_adhesion_fixed_grips, "J/m2");
    fixed_grips.source = "W = 6|F_po|/(5 pi R), fixed grips";
    add(json, fixed_grips);
    add(json, quantity("machine_stiffness", "k", pull_off.machine_stiffness, "N/m"));
    return json;
}

Json retraction_json(const experiment::RetractionFit& fit) {
    Json json;
    auto work = quantity("work_of_adhesion", "W_ret", fit.work_of_adhesion, "J/m2");
    work.source = "[D19] (S2) on the last points before pull-off";
    work.n = static_cast<int>(fit.n);
    add(json, work);
    add(json, quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    json["contact_modulus_free"] = fit.modulus_free;
    json["first"] = fit.first;
    json["last"] = fit.last;
    add(json, quantity("rms_residual", "rms", fit.rms_residual, "N"));
    json["contact_radius_measured"] = fit.radius_measured;
    return json;
}

Json energy_json(const experiment::LoopEnergy& loop, const experiment::LoopContext& context) {
    Json json;
    auto energy = quantity("energy", "E_loss", loop.estimate(), "J");
    energy.source = "closed integral of F d(delta), baseline and linear drift removed";
    add(json, energy);
    add(json, quantity("energy_without_drift", "E_loss", loop.without_drift, "J"));
    const auto& budget = loop.standard_error;
    json["standard_error_budget"] = {{"noise", number(budget.noise)},
                                     {"drift", number(budget.drift)},
                                     {"sampling", number(budget.sampling)},
                                     {"discretisation", number(budget.discretisation)},
                                     {"unit", "J"}};
    auto ideal = quantity("ideal_smooth_sphere_loss", "E_ideal", context.ideal_smooth_sphere_loss, "J");
    ideal.source = "jumps of the ideal smooth JKR sphere under fixed grips, E* and W of loading";
    add(json, ideal);
    return json;
}

Json cycle_json(const experiment::CycleAnalysis& cycle) {
    Json json;
    add_outcome(json, "loading", cycle.loading, branch_json);
    add_outcome(json, "unloading", cycle.unloading, branch_json);
    add_outcome(json, "energy", cycle.energy, [](double energy) { return to_json(quantity("energy", "E_loss", energy, "J")); });
    return json;
}

}  // namespace

Json to_json(const experiment::LoopAnalysis& analysis) {
    Json json;
    json["loading"] = branch_json(analysis.loading);
    add_outcome(json, "unloading", analysis.unloading, branch_json);
    add_outcome(json, "retraction", analysis.retraction, retraction_json);
    add_outcome(json, "pull_off", analysis.pull_off, pull_off_json);
    add_outcome(json, "loop", analysis.loop, [&](const experiment::LoopEnergy& loop) { return energy_json(loop, analysis.context); });
    auto radius = quantity("largest_contact_radius", "a_max", analysis.context.largest_contact_radius, "m");
    radius.source = analysis.context.radius_measured ? "measured" : "JKR at the largest force, loading fit";
    add(json, radius);
    add(json, quantity("largest_contact_area", "pi a_max^2", analysis.context.largest_contact_area, "m2"));
    add(json, quantity("tabor_parameter", "mu", analysis.context.tabor_parameter, "1"));
    Json cycles = Json::array();
    for (const auto& cycle : analysis.cycles) cycles.push_back(cycle_json(cycle));
    json["cycles"] = cycles;
    json["alerts"] = to_json(analysis.alerts);
    return json;
}

}  // namespace setae::workflow
