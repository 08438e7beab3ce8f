// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/fit_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "json_support.hpp"
#include "setae/core/constants.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {
namespace {

/// A quantity with its estimate, or null and the reason.
void add_estimate(Json& json, const char* name, const char* symbol, const study::Outcome<Estimate>& estimate,
                  const char* unit) {
    add_outcome(json, name, estimate, [&](const Estimate& e) { return to_json(quantity(name, symbol, e, unit)); });
}

void add_residuals(Json& json, const char* name, const loops::ChannelResiduals& residuals, const char* unit) {
    if (residuals.values.size() > 0)
        json[name] = {{"rms", number(residuals.rms)}, {"unit", unit}, {"values", numbers(residuals.values)}};
}

Json channels(loops::Channels used) {
    switch (used) {
        case loops::Channels::force_radius: return {"force", "contact_radius"};
        case loops::Channels::force_displacement: return {"force", "displacement"};
        case loops::Channels::force_displacement_radius: return {"force", "displacement", "contact_radius"};
    }
    return nullptr;
}

Json json_of(const loops::ParameterProfile& profile, const char* name, const char* symbol, const char* unit) {
    Json json = to_json(quantity(name, symbol, profile.estimate, unit));
    json["values"] = numbers(profile.values);
    json["chi_squared_rise"] = numbers(profile.chi2_rise);
    json["threshold"] = number(profile.threshold);
    return json;
}

Json json_of(const loops::RangeFit& range) {
    Json json{{"samples_dropped", range.dropped}, {"force_share", number(range.force_share)}};
    if (!range.fit) {
        json["reason"] = range.fit.reason;
        return json;
    }
    add(json, quantity("contact_modulus", "E*", range.fit->contact_modulus, "Pa"));
    add(json, quantity("work_of_adhesion", "W", range.fit->work_of_adhesion, "J/m2"));
    json["correlation"] = number(range.fit->correlation);
    return json;
}

Json json_of(const loops::CurveSegment& segment) {
    Json json{{"name", segment.name}, {"first", segment.range.first}, {"last", segment.range.last}};
    json["baseline"] = {{"force", number(segment.baseline.force)},
                        {"slope", number(segment.baseline.slope)},
                        {"force_noise", number(segment.baseline.force_noise)}};
    add(json, quantity("contact_point_found", "delta0", segment.contact_point, "m"));
    add(json, quantity("smallest_force", "F_po", segment.smallest_force, "N"));
    return json;
}

Json json_of(const loops::ForceCurveFit& fit) {
    Json json = json_of(fit.segment);
    json["tip"] = to_string(fit.shape);
    json["model"] = to_string(fit.model);
    json["converged"] = fit.converged;
    add(json, quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    add(json, quantity("youngs_modulus", "E", fit.youngs_modulus, "Pa"));
    add_estimate(json, "work_of_adhesion", "W", fit.work_of_adhesion, "J/m2");
    add(json, quantity("contact_point", "delta0", fit.contact_point, "m"));
    add(json, quantity("force_offset", "F0", fit.force_offset, "N"));
    add(json, quantity("indentation_from", "delta", fit.indentation_from, "m"));
    add(json, quantity("indentation_to", "delta", fit.indentation_to, "m"));
    json["n"] = fit.n;
    json["covariance"] = matrix(fit.covariance);
    add(json, quantity("rms_residual", "rms", fit.rms_residual, "N"));
    json["relative_residual"] = number(fit.relative_residual);
    json["residuals"] = numbers(fit.residuals);
    if (fit.model_fit) json["fit"] = to_json(*fit.model_fit);
    return json;
}

}  // namespace

Json to_json(const loops::ModelFit& fit) {
    Json json{{"model", to_string(fit.model)},
              {"channels", channels(fit.channels)},
              {"errors", to_string(fit.errors)},
              {"converged", fit.converged}};
    add(json, quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    add(json, quantity("youngs_modulus", "E", fit.youngs_modulus, "Pa"));
    add_estimate(json, "work_of_adhesion", "W", fit.work_of_adhesion, "J/m2");
    if (fit.model == loops::ContactModel::maugis_dugdale || fit.model == loops::ContactModel::transition) {
        add_estimate(json, "cohesive_stress", "sigma0", fit.cohesive_stress, "Pa");
        add_estimate(json, "transition_parameter", "lambda", fit.transition_parameter, "1");
    }
    if (fit.model == loops::ContactModel::transition) {
        add_estimate(json, "transition_share", "alpha", fit.transition_share, "1");
        add_estimate(json, "zero_load_radius", "a0", fit.zero_load_radius, "m");
        add_estimate(json, "pull_off_force", "F_c", fit.pull_off_force, "N");
    }
    if (!std::isnan(fit.contact_point.value)) add(json, quantity("contact_point", "delta0", fit.contact_point, "m"));
    json["parameters"] = fit.parameters;
    json["covariance"] = matrix(fit.covariance);
    json["correlations"] = matrix(fit.correlations);
    if (!fit.undetermined.empty()) json["undetermined"] = fit.undetermined;
    json["n"] = fit.n;
    json["degrees_of_freedom"] = number(fit.degrees_of_freedom);
    json["chi_squared_reduced"] = number(fit.chi2_reduced);
    json["noise_known"] = fit.noise.all_known;
    json["akaike"] = number(fit.akaike);
    json["correlated_samples"] = number(fit.correlated_samples);
    json["runs"] = to_json(fit.runs);
    add_residuals(json, "force_residuals", fit.force_residuals, "N");
    add_residuals(json, "displacement_residuals", fit.displacement_residuals, "m");
    add_residuals(json, "contact_radius_residuals", fit.contact_radius_residuals, "m");
    if (fit.verdict)
        json["applies"] = {{"sentence", fit.verdict->sentence},
                           {"tabor_parameter", number(fit.verdict->tabor_parameter)},
                           {"transition_parameter", number(fit.verdict->transition_parameter)}};
    return json;
}

Json to_json(const loops::ModelComparison& comparison) {
    Json json{{"channels", channels(comparison.channels)}, {"models", Json::array()}};
    for (const auto& model : comparison.models) {
        Json entry =
            model.fit ? to_json(*model.fit) : Json{{"model", to_string(model.model)}, {"reason", model.fit.reason}};
        entry["akaike_difference"] = number(model.akaike_difference);
        entry["akaike_weight"] = number(model.akaike_weight);
        json["models"].push_back(entry);
    }
    json["best"] = comparison.best ? Json(to_string(*comparison.best)) : Json(nullptr);
    json["sentence"] = comparison.sentence;
    return json;
}

Json to_json(const loops::GlobalFit& fit) {
    Json json{{"model", to_string(fit.options.fit.model)}, {"converged", fit.converged}};
    if (fit.contact_modulus) add(json, quantity("contact_modulus", "E*", *fit.contact_modulus, "Pa"));
    if (fit.work_of_adhesion) add(json, quantity("work_of_adhesion", "W", *fit.work_of_adhesion, "J/m2"));
    json["loops"] = Json::array();
    for (const auto& branch : fit.branches) {
        Json entry{{"name", branch.name}, {"n", branch.n}, {"chi_squared", number(branch.chi2)}};
        add(entry, quantity("contact_modulus", "E*", branch.contact_modulus, "Pa"));
        add(entry, quantity("youngs_modulus", "E", branch.youngs_modulus, "Pa"));
        add_estimate(entry, "work_of_adhesion", "W", branch.work_of_adhesion, "J/m2");
        entry["separate"] = to_json(branch.separate);
        json["loops"].push_back(entry);
    }
    json["parameters"] = fit.parameters;
    json["covariance"] = matrix(fit.covariance);
    json["n"] = fit.n;
    json["chi_squared_reduced"] = number(fit.chi2_reduced);
    json["sharing_test"] = {{"f_ratio", number(fit.sharing.f_ratio)},
                            {"extra_parameters", number(fit.sharing.extra_parameters)},
                            {"degrees_of_freedom", number(fit.sharing.degrees_of_freedom)},
                            {"p_value", number(fit.sharing.p_value)}};
    return json;
}

Json to_json(const loops::CrackSpeedFit& fit) {
    Json json{{"converged", fit.converged}, {"n", fit.n}};
    add(json, quantity("threshold", "G0", fit.threshold, "J/m2"));
    add(json, quantity("reference_speed", "v0", fit.reference_speed, "m/s"));
    add(json, quantity("exponent", "n", fit.exponent, "1"));
    add(json, quantity("contact_modulus", "E*", fit.contact_modulus, "Pa"));
    json["modulus_deviation"] = number(fit.modulus_deviation);
    json["covariance"] = matrix(fit.covariance);
    json["chi_squared_reduced"] = number(fit.chi2_reduced);
    json["relative_residual"] = number(fit.relative_residual);
    json["speed_ratio"] = number(fit.speed_ratio);
    json["residuals"] = numbers(fit.residuals);
    return json;
}

Json to_json(const std::vector<loops::NamedCurveFit>& segments) {
    Json json = Json::array();
    for (const auto& segment : segments)
        json.push_back(segment.fit ? json_of(*segment.fit)
                                   : Json{{"name", segment.name}, {"reason", segment.fit.reason}});
    return json;
}

Json to_json(const loops::ProfileLikelihood& profile) {
    return {{"method", profile.fit.method},
            {"contact_modulus", json_of(profile.contact_modulus, "contact_modulus", "E*", "Pa")},
            {"work_of_adhesion", json_of(profile.work_of_adhesion, "work_of_adhesion", "W", "J/m2")}};
}

Json to_json(const study::LoopModels& models) {
    Json json = Json::object();
    if (!models.fits.empty()) {
        json["fits"] = Json::array();
        for (const auto& fit : models.fits) json["fits"].push_back(to_json(fit));
    }
    if (models.comparison) json["comparison"] = to_json(*models.comparison);
    if (models.profile) json["profile_likelihood"] = to_json(*models.profile);
    if (models.crack_speed) json["crack_speed"] = to_json(*models.crack_speed);
    if (!models.failures.empty()) json["failures"] = models.failures;
    return json;
}

Json to_json(const loops::RangeScan& scan) {
    Json json{{"by_start", Json::array()}, {"by_end", Json::array()}};
    for (const auto& fit : scan.by_start) json["by_start"].push_back(json_of(fit));
    for (const auto& fit : scan.by_end) json["by_end"].push_back(json_of(fit));
    add(json, quantity("slope", "dW/dE*", scan.slope, "J/(m2 Pa)"));
    add(json, quantity("ellipse_slope", "dW/dE*", scan.ellipse_slope, "J/(m2 Pa)"));
    return json;
}

}  // namespace setae::output
