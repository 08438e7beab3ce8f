// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/fit_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "json_support.hpp"
#include "loop_model_fields.hpp"
#include "setae/core/constants.hpp"
#include "setae/output/field_json.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {
namespace {

/// A quantity with its estimate, or null and the reason.
void add_estimate(Json& json, const char* name, const char* symbol, const study::Outcome<Estimate>& estimate,
                  const char* unit) {
    add_outcome(json, name, estimate, [&](const Estimate& e) { return to_json(quantity(name, symbol, e, unit)); });
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

Json to_json(const loops::ModelFit& fit) { return described(fit); }

Json to_json(const loops::ModelComparison& comparison) { return described(comparison); }

Json to_json(const loops::GlobalFit& fit) { return described(fit); }

Json to_json(const loops::CrackSpeedFit& fit) { return described(fit); }

Json to_json(const std::vector<loops::NamedCurveFit>& segments) {
    Json json = Json::array();
    for (const auto& segment : segments)
        json.push_back(segment.fit ? json_of(*segment.fit)
                                   : Json{{"name", segment.name}, {"reason", segment.fit.reason}});
    return json;
}

Json to_json(const loops::ProfileLikelihood& profile) { return described(profile); }

Json to_json(const study::LoopModels& models) { return described(models); }

Json to_json(const loops::RangeScan& scan) {
    Json json{{"by_start", Json::array()}, {"by_end", Json::array()}};
    for (const auto& fit : scan.by_start) json["by_start"].push_back(json_of(fit));
    for (const auto& fit : scan.by_end) json["by_end"].push_back(json_of(fit));
    add(json, quantity("slope", "dW/dE*", scan.slope, "J/(m2 Pa)"));
    add(json, quantity("ellipse_slope", "dW/dE*", scan.ellipse_slope, "J/(m2 Pa)"));
    return json;
}

}  // namespace setae::output
