// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "json_support.hpp"

#include <cmath>

namespace setae::output {
namespace {

using loops::JkrFit;

constexpr Index most_samples = 20'000;

/// Every how many samples of a record a column holds: all of one that is not very long.
Index stride_of(Index samples) { return (samples + most_samples - 1) / most_samples; }

Json samples_json(const Array1D& values) {
    const auto stride = stride_of(values.size());
    if (stride <= 1) return numbers(values);
    Json list = Json::array();
    for (Index i = 0; i < values.size(); i += stride) list.push_back(number(values[i]));
    return list;
}

void add_stride(Json& json, const char* name, Index samples) {
    if (const auto stride = stride_of(samples); stride > 1) json[name] = stride;
}

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
    if (!std::isnan(fit.contact_point.value)) add(json, quantity("contact_point", "delta0", fit.contact_point, "m"));
    json["correlation"] = number(fit.correlation);
    json["correlated_samples"] = number(fit.correlated_samples);
    json["covariance"] = matrix(fit.covariance);
    json["n"] = fit.n;
    json["within_noise"] = fit.within_noise ? Json(*fit.within_noise) : Json();
    if (fit.unbounded_work) add(json, quantity("unbounded_work_of_adhesion", "W", *fit.unbounded_work, "J/m2"));
    json["chi_squared_reduced"] = number(fit.chi2_reduced);
    add(json, quantity("rms_residual", "rms", fit.rms_residual, fit.residual_unit));
    json["relative_residual"] = number(fit.relative_residual);
    json["residuals"] = samples_json(fit.residuals);
    if (fit.depth_residuals.size() > 0) json["depth_residuals"] = samples_json(fit.depth_residuals);
    add_stride(json, "residuals_every", fit.residuals.size());
    json["runs"] = to_json(fit.runs);
    return json;
}

Json pointwise_json(const loops::PointwiseModulus& fit) {
    Json json;
    add(json, quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    add(json, quantity("youngs_modulus", "E", fit.youngs_modulus, "Pa"));
    add(json, quantity("contact_point", "delta0", fit.contact_point, "m"));
    json["n"] = fit.n;
    json["relative_residual"] = number(fit.relative_residual);
    return json;
}

Json range_json(const loops::FitRange& range) {
    return {{"name", range.name},
            {"first", range.first},
            {"last", range.last},
            {"n", range.n},
            {"force_first", to_json(quantity("force", "F", range.force_first, "N"))},
            {"force_last", to_json(quantity("force", "F", range.force_last, "N"))}};
}

Json branch_json(const loops::BranchAnalysis& branch) {
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
    json["energy_release_rate"] = {
        {"contact_radius", samples_json(branch.energy_release_rate.contact_radius)},
        {"contact_radius_unit", "m"},
        {"energy_release_rate", samples_json(branch.energy_release_rate.energy_release_rate)},
        {"standard_error", samples_json(branch.energy_release_rate.standard_error)},
        {"systematic", samples_json(branch.energy_release_rate.systematic)},
        {"energy_release_rate_unit", "J/m2"},
        {"contact_radius_measured", branch.energy_release_rate.radius_measured}};
    add_stride(json["energy_release_rate"], "every", branch.energy_release_rate.contact_radius.size());
    Json sensitivity = Json::array();
    for (const auto& entry : branch.sensitivity) {
        Json row{{"samples_dropped", entry.dropped}};
        if (entry.fit) add_moduli_and_work(row, *entry.fit);
        else row["reason"] = entry.fit.reason;
        sensitivity.push_back(row);
    }
    json["sensitivity_to_range"] = sensitivity;
    return json;
}

Json pull_off_json(const loops::PullOff& pull_off) {
    Json json{{"index", pull_off.index}};
    add(json, quantity("force", "F_po", pull_off.force, "N"));
    auto fixed_load = quantity("work_of_adhesion", "W_po", pull_off.work_of_adhesion, "J/m2");
    fixed_load.source = "at pull-off, W = 2|F_po|/(3 pi R), the smallest force; [D19] (S1)";
    add(json, fixed_load);
    add(json, quantity("last_force", "F_last", pull_off.last_force, "N"));
    add_outcome(json, "work_of_adhesion_fixed_grips", pull_off.work_of_adhesion_fixed_grips, [](const Estimate& work) {
        auto fixed_grips = quantity("work_of_adhesion_fixed_grips", "W_po", work, "J/m2");
        fixed_grips.source = "W = 6|F_last|/(5 pi R), fixed grips";
        return to_json(fixed_grips);
    });
    add(json, quantity("machine_stiffness", "k", pull_off.machine_stiffness, "N/m"));
    return json;
}

Json retraction_json(const loops::RetractionFit& fit) {
    Json json;
    auto work = quantity("work_of_adhesion", "W_ret", fit.work_of_adhesion, "J/m2");
    work.source = "at pull-off, [D19] (S2) on the last points";
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

Json work_along_json(const loops::WorkAlongRetraction& along) {
    Json json;
    add(json, quantity("work_at_pull_off", "W_ret(a_po)", along.at_pull_off, "J/m2"));
    add(json, quantity("work_at_largest_contact", "W_ret(a_max)", along.at_largest_contact, "J/m2"));
    auto slope = quantity("slope", "dW_ret/da", along.slope, "J/m3");
    slope.source = "line through G(a) = (4E*a^3/3R - F)^2/(8 pi E* a^3) of the receding edge";
    slope.n = static_cast<int>(along.n);
    add(json, slope);
    add(json, quantity("smallest_contact_radius", "a_po", along.smallest_radius, "m"));
    add(json, quantity("largest_contact_radius", "a_max", along.largest_radius, "m"));
    add(json, quantity("rms_residual", "rms", along.rms_residual, "J/m2"));
    json["chi_squared_reduced"] = number(along.chi2_reduced);
    add(json, quantity("energy_loss", "E_loss", along.energy_loss, "J"));
    add(json, quantity("energy_loss_constant_work", "E_loss", along.energy_loss_constant, "J"));
    return json;
}

Json budget_json(const loops::LoopErrorBudget& budget) {
    return {{"noise", number(budget.noise)},
            {"drift", number(budget.drift)},
            {"compliance", number(budget.compliance)},
            {"sampling", number(budget.sampling)},
            {"discretisation", number(budget.discretisation)},
            {"unit", "J"}};
}

Json energy_json(const loops::LoopEnergy& loop, const loops::LoopContext& context) {
    Json json;
    auto energy = quantity("energy", "E_loss", loop.estimate(), "J");
    energy.source = "closed integral of F d(delta), baseline and linear drift removed";
    add(json, energy);
    add(json, quantity("energy_without_drift", "E_loss", loop.without_drift, "J"));
    json["standard_error_budget"] = budget_json(loop.standard_error);
    auto ideal = quantity("ideal_smooth_sphere_loss", "E_ideal", context.ideal_smooth_sphere_loss, "J");
    ideal.source = "jumps of the ideal smooth JKR sphere under fixed grips, E* and W of loading";
    add(json, ideal);
    return json;
}

Json work_json(const loops::WorkEntry& entry) {
    Json json{{"first", entry.range.first}, {"last", entry.range.last}};
    add(json,
        quantity(
            "work", "int F d(delta)",
            Estimate{.value = entry.energy, .standard_error = entry.standard_error.total, .method = "error budget"},
            "J"));
    json["standard_error_budget"] = budget_json(entry.standard_error);
    return json;
}

Json ledger_json(const loops::EnergyLedger& ledger) {
    Json json;
    json["before_contact"] = work_json(ledger.before_contact);
    json["jump_in"] = ledger.jump_in ? work_json(*ledger.jump_in) : Json();
    json["approach"] = work_json(ledger.approach);
    json["retraction"] = work_json(ledger.retraction);
    json["jump_out"] = ledger.jump_out ? work_json(*ledger.jump_out) : Json();
    json["after_contact"] = work_json(ledger.after_contact);
    add(json, quantity("recovered_share", "recovered", ledger.recovered_share, "1"));
    add(json, quantity("ideal_loss_fixed_grips", "E_ideal", ledger.ideal_fixed_grips, "J"));
    add(json, quantity("ideal_loss_this_machine", "E_ideal", ledger.ideal_this_machine, "J"));
    add(json, quantity("machine_stiffness", "k", ledger.machine_stiffness, "N/m"));
    add(json, quantity("true_area_ratio", "r", ledger.true_area_ratio, "1"));
    add(json, quantity("largest_true_area", "r pi a_max^2", ledger.largest_true_area(), "m2"));
    add(json, quantity("loss_per_apparent_area", "E_loss/A", ledger.loss_per_apparent_area, "J/m2"));
    add(json, quantity("loss_per_true_area", "E_loss/A_true", ledger.loss_per_true_area, "J/m2"));
    return json;
}

Json contact_points_json(const loops::ContactPoints& points) {
    Json json;
    json["chosen"] = points.chosen ? Json(loops::contact_point_name(*points.chosen)) : Json("given");
    add(json, quantity("contact_point", "delta0", points.contact_point, "m"));
    Json estimates = Json::array();
    for (const auto& estimate : points.estimates) {
        Json row{{"method", loops::contact_point_name(estimate.method)}};
        if (estimate.contact_point) add(row, quantity("contact_point", "delta0", *estimate.contact_point, "m"));
        else row["reason"] = estimate.contact_point.reason;
        if (estimate.fit) add_moduli_and_work(row, *estimate.fit);
        estimates.push_back(row);
    }
    json["estimates"] = estimates;
    add(json, quantity("spread", "spread", points.spread, "m"));
    add(json, quantity("spread_share", "spread", points.spread_share, "1"));
    json["chi_squared"] = number(points.chi2);
    json["degrees_of_freedom"] = points.degrees_of_freedom;
    add(json, quantity("work_by_contact_point", "dW/d(delta0)", points.work_by_contact_point, "J/m3"));
    add(json, quantity("modulus_by_contact_point", "dE*/d(delta0)", points.modulus_by_contact_point, "Pa/m"));
    return json;
}

Json compliance_json(const loops::ComplianceEffect& effect) {
    Json json;
    add(json, quantity("machine_stiffness", "k", effect.stiffness, "N/m"));
    add(json, quantity("modulus_change", "E*(k + SE) - E*(k)", effect.modulus_change, "Pa"));
    add(json, quantity("work_change", "W(k + SE) - W(k)", effect.work_change, "J/m2"));
    add(json, quantity("energy_change", "of the approach", effect.energy_change, "J"));
    return json;
}

Json range_of(const std::optional<loops::IndexRange>& range) {
    return range ? Json{{"first", range->first}, {"last", range->last}} : Json();
}

Json segments_json(const loops::Segments& segments) {
    Json json{{"baseline_before", range_of(segments.before.range)},
              {"baseline_after", segments.after ? range_of(segments.after->range) : Json()}};
    Json contacts = Json::array();
    for (const auto& contact : segments.contacts) {
        Json row{{"extent", range_of(contact.extent)},       {"jump_in", range_of(contact.jump_in)},
                 {"loading", range_of(contact.loading)},     {"hold", range_of(contact.hold)},
                 {"unloading", range_of(contact.unloading)}, {"pull_off", range_of(contact.pull_off)}};
        contacts.push_back(row);
    }
    json["contacts"] = contacts;
    Json ignored = Json::array();
    for (const auto& range : segments.ignored) ignored.push_back(range_of(range));
    json["ignored"] = ignored;
    return json;
}

Json steps_json(const std::vector<loops::ForceStep>& steps) {
    Json json = Json::array();
    for (const auto& step : steps) {
        Json row{{"sample", step.sample}};
        add(row, quantity("size", "dF", step.size, "N"));
        json.push_back(row);
    }
    return json;
}

/// What was found of the zero of force, and taken off.
Json force_zero_json(const loops::LoopAnalysis& analysis) {
    const auto& drift = analysis.force_zero.drift;
    Json json{{"degree", drift.degree}, {"stretches", drift.stretches}, {"irregular", drift.irregular}};
    add(json, quantity("change", "dF0", drift.change, "N"));
    add(json, quantity("largest_in_contact", "dF0", drift.largest_in_contact, "N"));
    add(json, quantity("bend", "dF0", drift.bend, "N"));
    json["steps"] = steps_json(analysis.segments.steps);
    json["steps_in_contact"] = steps_json(analysis.steps_in_contact);
    return json;
}

template <class Contact>
void add_energies(Json& json, const Contact& analysis) {
    add_outcome(json, "loop", analysis.loop,
                [&](const loops::LoopEnergy& loop) { return energy_json(loop, analysis.context); });
    add_outcome(json, "ledger", analysis.ledger, ledger_json);
}

Json cycle_energy_json(const loops::CycleAnalysis& cycle) {
    Json json{{"contact", cycle.cycle.contact}};
    add_outcome(json, "energy", cycle.energy, [&](double energy) {
        return to_json(quantity(
            "energy", "E_loss",
            Estimate{.value = energy, .standard_error = cycle.energy_standard_error, .method = "error budget"}, "J"));
    });
    return json;
}

Json cycle_json(const loops::CycleAnalysis& cycle) {
    Json json;
    add_outcome(json, "loading", cycle.loading, branch_json);
    add_outcome(json, "unloading", cycle.unloading, branch_json);
    json["loading_samples"] = range_of(cycle.cycle.loading);
    json["unloading_samples"] = range_of(cycle.cycle.unloading);
    json.update(cycle_energy_json(cycle));
    return json;
}

Json hold_json(const loops::HoldGrowth& hold) {
    Json json{{"samples", {{"first", hold.samples.first}, {"last", hold.samples.last}}}};
    add(json, quantity("duration", "t", hold.duration, "s"));
    const auto add_change = [&](const std::string& name, const std::string& symbol, const loops::Change& change,
                                const std::string& unit) {
        add(json, quantity(name + "_first", symbol, change.first, unit));
        add(json, quantity(name + "_last", symbol, change.last, unit));
    };
    add_change("force", "F", hold.force, "N");
    if (hold.displacement) add_change("displacement", "delta", *hold.displacement, "m");
    if (hold.contact_radius) add_change("contact_radius", "a", *hold.contact_radius, "m");
    if (hold.work_of_adhesion) add_change("work_of_adhesion", "W", *hold.work_of_adhesion, "J/m2");
    return json;
}

/// What is known of one touch: the first, which stands for the record, or a further one.
template <class Contact>
Json contact_json(const Contact& analysis) {
    Json json;
    json["loading"] = branch_json(analysis.loading);
    if (analysis.hold) json["hold"] = hold_json(*analysis.hold);
    add_outcome(json, "unloading", analysis.unloading, branch_json);
    add_outcome(json, "retraction", analysis.retraction, retraction_json);
    add_outcome(json, "work_along_retraction", analysis.work_along_retraction, work_along_json);
    add_outcome(json, "pull_off", analysis.pull_off, pull_off_json);
    add_energies(json, analysis);
    add_outcome(json, "contact_points", analysis.contact_points, contact_points_json);
    if (analysis.compliance) json["compliance"] = compliance_json(*analysis.compliance);
    auto radius = quantity("largest_contact_radius", "a_max", analysis.context.largest_contact_radius, "m");
    radius.source = analysis.context.radius_measured ? "measured" : "JKR at the largest force, loading fit";
    add(json, radius);
    add(json, quantity("largest_contact_area", "pi a_max^2", analysis.context.largest_contact_area, "m2"));
    add(json, quantity("tabor_parameter", "mu", analysis.context.tabor_parameter, "1"));
    json["applicable_model"] = analysis.context.applicable_model;
    return json;
}

}  // namespace

Json energies_json(const loops::LoopAnalysis& analysis) {
    Json json;
    add_energies(json, analysis);
    json["further_contacts"] = Json::array();
    for (const auto& contact : analysis.further_contacts) {
        Json row = contact ? Json::object() : Json{{"reason", contact.reason}};
        if (contact) add_energies(row, *contact);
        json["further_contacts"].push_back(row);
    }
    json["cycles"] = Json::array();
    for (const auto& cycle : analysis.cycles) json["cycles"].push_back(cycle_energy_json(cycle));
    json["alerts"] = to_json(analysis.alerts);
    return json;
}

Json to_json(const loops::LoopAnalysis& analysis) {
    Json json = contact_json(analysis);
    if (analysis.bulk) {
        json["bulk_relaxation"] = Json::object();
        add(json["bulk_relaxation"], quantity("energy_loss", "E_bulk", analysis.bulk->energy_loss, "J"));
        add(json["bulk_relaxation"], quantity("largest_force", "F_1", analysis.bulk->largest_force, "N"));
    }
    Json further = Json::array();
    for (const auto& contact : analysis.further_contacts) {
        Json row;
        add_outcome(row, "contact", contact, contact_json<loops::ContactAnalysis>);
        further.push_back(row);
    }
    json["further_contacts"] = further;
    json["segments"] = segments_json(analysis.segments);
    json["force_zero"] = force_zero_json(analysis);
    Json cycles = Json::array();
    for (const auto& cycle : analysis.cycles) cycles.push_back(cycle_json(cycle));
    json["cycles"] = cycles;
    json["alerts"] = to_json(analysis.alerts);
    return json;
}

}  // namespace setae::output
