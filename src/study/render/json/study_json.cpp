// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "json_support.hpp"
#include "json_writer.hpp"
#include "setae/core/constants.hpp"
#include "setae/output/budget.hpp"
#include "setae/output/contact_answers.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/fit_json.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/output/predicted_quantities.hpp"
#include "setae/output/replicate_report.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/output/verdict.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::output {
namespace {

Quantity named(const char* name, const char* symbol, double value, const char* unit, std::string source) {
    auto q = quantity(name, symbol, value, unit);
    q.source = std::move(source);
    return q;
}

Json estimate_json(const adhesion::WorkEstimate& estimate, const char* unit_of_scatter) {
    Json json;
    add(json, quantity("work_of_adhesion", "W_int", estimate.work_of_adhesion, "J/m2"));
    add(json, quantity("chi_squared", "chi2", estimate.chi_squared, "1"));
    add(json, quantity("extra_scatter", "tau", estimate.extra_scatter, unit_of_scatter));
    return json;
}

/// A fit with the covariance of all errors: GeneralisedFit or GeneralisedFreeEnergies.
template <class Fit>
Json generalised_json(const Fit& fit, const Estimate& work_of_adhesion, const char* unit_of_scatter) {
    Json json;
    auto work = quantity("work_of_adhesion", "W_int", work_of_adhesion, "J/m2");
    work.n = fit.n;
    add(json, work);
    add(json, quantity("r_squared", "R2", fit.r_squared, "1"));
    for (const auto& [level, scatter] :
         {std::pair{"pair", fit.scatter.pair}, {"surface", fit.scatter.surface}, {"elastomer", fit.scatter.elastomer}})
        json["scatter"][level] = to_json(quantity("scatter", "tau", scatter, unit_of_scatter));
    return json;
}

Json generalised_free_json(const adhesion::GeneralisedFreeEnergies& fit) {
    auto json = generalised_json(fit, fit.work_of_adhesion, "J/m2");
    for (const auto& [surface, energy] : fit.energies)
        json["elastic_energy_per_modulus"][surface] =
            to_json(quantity("elastic_energy_per_modulus", "U_el/(A E*)", energy, "m"));
    return json;
}

Json budget_json(const std::vector<BudgetRow>& rows, const std::string& unit) {
    Json json = Json::array();
    for (const auto& row : rows)
        json.push_back({{"input", row.input},
                        {"standard_error", number(row.standard_error)},
                        {"share_of_variance", number(row.share)},
                        {"standard_error_with_half_of_it", number(row.halved)},
                        {"unit", unit}});
    return json;
}

Json budgets_json(const study::Conclusions& result) {
    Json json = Json::array();
    for (const auto& budget : budgets_of(result)) {
        Json entry{{"quantity", budget.quantity},
                   {"symbol", budget.symbol},
                   {"standard_error", number(budget.standard_error)},
                   {"unit", budget.unit},
                   {"inputs", budget_json(budget.rows, budget.unit)}};
        if (!budget.surface.empty()) {
            entry["surface"] = budget.surface;
            entry["elastomer"] = budget.elastomer;
        }
        json.push_back(std::move(entry));
    }
    return json;
}

Json left_out_json(const study::Conclusions& result) {
    Json json = Json::array();
    for (const auto& p : result.left_out) {
        Json entry{{"left_out", p.surface_left_out ? "surface" : "elastomer"},
                   {"name", p.surface_left_out ? p.surface : p.elastomer},
                   {"surface", p.surface},
                   {"elastomer", p.elastomer}};
        entry["predicted"] = to_json(quantity("work_of_adhesion", "W_app", p.predicted, "J/m2"));
        entry["measured"] = to_json(quantity("work_of_adhesion_approach", "W_app", p.measured, "J/m2"));
        entry["residual"] =
            to_json(quantity("residual", "measured - predicted",
                             {.value = p.residual, .standard_error = p.standard_error, .method = "delta"}, "J/m2"));
        entry["held"] = p.held;
        json.push_back(std::move(entry));
    }
    return json;
}

/// W_int and the likelihood of the pairs against each stated input.
Json profiles_json(const study::Conclusions& result) {
    Json json = Json::array();
    for (const auto& profile : result.profiles) {
        Json entry{{"input", profile.input}, {"points", Json::array()}};
        entry["by_pairs"] = to_json(quantity("shift", "(x - told)/u(x)", profile.by_pairs, "1"));
        for (const auto& point : profile.points)
            entry["points"].push_back(
                {{"shift", point.shift},
                 {"work_of_adhesion", to_json(quantity("work_of_adhesion", "W_int", point.work_of_adhesion, "J/m2"))},
                 {"log_likelihood", number(point.log_likelihood)}});
        json.push_back(std::move(entry));
    }
    return json;
}

Json fit_json(const adhesion::WorkFit& fit, const char* source, const char* unit) {
    Json json;
    auto work = quantity("work_of_adhesion", "W_int", fit.work_of_adhesion, "J/m2");
    work.n = fit.n;
    work.source = source;
    add(json, work);
    add(json, quantity("r_squared", "R2", fit.r_squared, "1"));
    add(json, quantity("clustered_standard_error", "SE", fit.clustered.standard_error, "J/m2"));
    json["clustered"] = to_json(quantity("work_of_adhesion", "W_int", fit.clustered, "J/m2"));
    json["generalised"] = generalised_json(fit.generalised, fit.generalised.estimate(), unit);
    json["posterior"] =
        fit.posterior ? to_json(quantity("work_of_adhesion", "W_int", *fit.posterior, "J/m2")) : Json(nullptr);
    json["likelihood"] =
        fit.likelihood ? to_json(quantity("work_of_adhesion", "W_int", *fit.likelihood, "J/m2")) : Json(nullptr);
    add(json, quantity("residual_standard_deviation", "s", fit.residual_standard_deviation, unit));
    json["n"] = fit.n;
    json["degrees_of_freedom"] = fit.degrees_of_freedom;
    json["weighted"] = fit.weighted ? estimate_json(*fit.weighted, unit) : Json(nullptr);
    json["with_extra_scatter"] = fit.with_extra_scatter ? estimate_json(*fit.with_extra_scatter, unit) : Json(nullptr);
    json["errors_in_both"] = fit.errors_in_both ? estimate_json(*fit.errors_in_both, unit) : Json(nullptr);
    json["residuals"] = Json::array();
    for (const auto& pair : fit.pairs) {
        const double predicted = pair.prediction(fit.work_of_adhesion.value);
        Json entry{{"surface", pair.surface}, {"elastomer", pair.elastomer}};
        add(entry, quantity("measured", "y", pair.measured, unit));
        add(entry, quantity("predicted", "f", predicted, unit));
        add(entry, quantity("residual", "y - f", pair.measured.value - predicted, unit));
        json["residuals"].push_back(entry);
    }
    return json;
}

Json line_json(const std::optional<adhesion::LineFit>& fit) {
    if (!fit) return nullptr;
    Json json;
    add(json, quantity("work_of_adhesion", "W_int", fit->slope, "J/m2"));
    add(json, quantity("intercept", "E_0", fit->intercept, "J"));
    add(json, quantity("r_squared", "R2", fit->r_squared, "1"));
    json["n"] = fit->n;
    return json;
}

Json loop_fits_json(const adhesion::LossFits& fits) {
    auto json = fit_json(fits.through_origin, "E_loss = W_int A_true; [D19] (10)", "J");
    json["with_intercept"] = line_json(fits.with_intercept);
    json["without_ideal_loss"] = fits.through_origin_without_ideal_loss
                                     ? fit_json(*fits.through_origin_without_ideal_loss,
                                                "E_loss minus the loss of the smooth sphere = W_int A_true", "J")
                                     : Json(nullptr);
    json["without_ideal_loss_with_intercept"] = line_json(fits.with_intercept_without_ideal_loss);
    return json;
}

Json free_json(const adhesion::FreeEnergyFit& fit) {
    Json json;
    auto work = quantity("work_of_adhesion", "W_int", fit.work_of_adhesion, "J/m2");
    work.source = "(7) with U_el/(A E*) free for each surface: no power spectrum can do better";
    add(json, work);
    add(json, quantity("r_squared", "R2", fit.r_squared, "1"));
    for (const auto& [surface, energy] : fit.energy_per_modulus)
        json["elastic_energy_per_modulus"][surface] =
            to_json(quantity("elastic_energy_per_modulus", "U_el/(A E*)", energy, "m"));
    json["generalised"] = fit.generalised ? generalised_free_json(*fit.generalised) : Json(nullptr);
    return json;
}

Json interface_json(const adhesion::StrainedInterfaceFit& fit) {
    Json json;
    add(json, quantity("work_of_adhesion", "W_int", fit.work_of_adhesion, "J/m2"));
    add(json, quantity("interface_change", "chi", fit.interface_change, "J/m2"));
    add(json, quantity("correlation", "rho", fit.correlation, "1"));
    add(json, quantity("r_squared", "R2", fit.r_squared, "1"));
    json["n"] = fit.n;
    return json;
}

/// W_int,e = c W_app of the reference on e.
Json reference_scaled_json(const adhesion::WorkFit& fit) {
    Json json;
    add(json, quantity("reference_factor", "c", fit.stated(), "1"));
    json["least_squares"] = to_json(quantity("reference_factor", "c", fit.work_of_adhesion, "1"));
    json["generalised"] = to_json(quantity("reference_factor", "c", fit.generalised.estimate(), "1"));
    add(json, quantity("r_squared", "R2", fit.r_squared, "1"));
    json["n"] = fit.n;
    return json;
}

Json fits_json(const study::Conclusions& result) {
    Json json;
    add_outcome(json, "modified", result.modified,
                [](const adhesion::WorkFit& fit) { return fit_json(fit, "[D19] (7), floored at 0", "J/m2"); });
    add_outcome(json, "persson_tosatti", result.persson_tosatti,
                [](const adhesion::WorkFit& fit) { return fit_json(fit, "[D19] (S13), floored at 0", "J/m2"); });
    add_outcome(json, "without_area_change", result.without_area_change,
                [](const adhesion::WorkFit& fit) { return fit_json(fit, "[D19] (2), floored at 0", "J/m2"); });
    add_outcome(json, "loop", result.loop, loop_fits_json);
    add_outcome(json, "free_energies", result.free_energies, free_json);
    add_outcome(json, "strained_interface", result.strained_interface, interface_json);
    add_outcome(json, "reference_scaled", result.reference_scaled, reference_scaled_json);
    return json;
}

Json measurement_json(const study::MeasurementResult& m) {
    Json json{{"file", m.file}, {"name", m.name}};
    if (m.failed()) {
        json["error"] = m.error;
        return json;
    }
    const auto& instrument = m.spectrum.metadata.instrument;
    json["instrument"] = instrument.type.empty() ? instrument.name : instrument.type;
    json["format"] = m.spectrum.metadata.format;
    if (m.channel) json["channel"] = *m.channel;
    if (!m.processing.empty()) json["processing"] = to_json(m.processing);
    json["trend_removed"] = topography::name(m.trend);
    json["window"] = m.spectrum.window;
    json["band"] = {
        {"lower", number(m.spectrum.band.lower)}, {"upper", number(m.spectrum.band.upper)}, {"unit", "1/m"}};
    for (const auto& q : measurement_quantities(m)) add(json, q);
    json["alerts"] = to_json(m.alerts);
    return json;
}

Json spectrum_json(const study::SurfaceResult& surface, const study::SpectrumResult& spectrum,
                   const study::SurfaceAnalysisOptions& options) {
    Json json;
    for (const auto& q : surface_quantities(surface, spectrum, options.conversion)) add(json, q);
    if (const auto decades = decade_quantities(surface, spectrum); !decades.empty()) {
        json["decades"] = Json::array();
        for (const auto& q : decades) json["decades"].push_back(to_json(q));
    }
    json["conversion"] = options.conversion == roughness::Conversion::exact ? "exact" : "eq11";
    if (spectrum.other_conversion) {
        Json other;
        const auto& p = *spectrum.other_conversion;
        const char* source = options.conversion == roughness::Conversion::exact ? eq11_source : exact_source;
        add(other, named("rms_height", "h_rms", p.rms_height, "m", source));
        add(other, named("rms_slope", "h'_rms", p.rms_slope, "1", source));
        add(other, named("rms_curvature", "h''_rms", p.rms_curvature, "1/m", source));
        add(other, named("elastic_energy_per_modulus", "U_el/(A E*)", p.elastic_energy_per_modulus, "m", source));
        json["other_conversion"] = other;
    }
    add(json, named("energy_cut_by_limits", "1 - U_el/U_el,uncut",
                    1.0 - spectrum.parameters.elastic_energy_per_modulus / spectrum.uncut_energy_per_modulus, "1",
                    "share of the stored energy outside longest_wavelength … shortest_wavelength"));
    return json;
}

/// Parameters with waves beyond an end of the data.
Json continuation_json(const roughness::BeyondData& beyond) {
    Json json;
    add(json, quantity("end_of_data", "q_e", beyond.end, "1/m"));
    add(json, quantity("end_of_waves", "q_s", beyond.up_to, "1/m"));
    add(json, quantity("exponent", "p", beyond.exponent, "1"));
    add(json, quantity("rms_height", "h_rms", beyond.rms_height, "m"));
    add(json, quantity("rms_slope", "h'_rms", beyond.rms_slope, "1"));
    add(json, quantity("excess_area", "A_true/A_app - 1", beyond.excess_area, "1"));
    add(json, quantity("elastic_energy_per_modulus", "U_el/(A E*)", beyond.elastic_energy_per_modulus, "m"));
    return json;
}

Json elastomer_json(const study::ElastomerResult& elastomer) {
    Json json;
    auto modulus = quantity("youngs_modulus", "E", elastomer.youngs_modulus, "Pa");
    modulus.source = elastomer.modulus_from_loops ? "mean of the loops on it" : "given";
    add(json, modulus);
    add(json, quantity("contact_modulus", "E*", elastomer.contact_modulus, "Pa"));
    add(json, quantity("surface_energy", "gamma_1", elastomer.input.surface_energy, "J/m2"));
    if (elastomer.network_modulus)
        add(json, named("network_modulus", "rho R T/M_c", *elastomer.network_modulus, "Pa",
                        "plausibility, not a measurement"));
    if (elastomer.shared_fit)
        add_outcome(json, "shared_fit", *elastomer.shared_fit,
                    [](const loops::GlobalFit& fit) { return to_json(fit); });
    json["alerts"] = to_json(elastomer.alerts);
    return json;
}

Json predicted_json(const adhesion::PredictedWork& predicted, const Estimate& floored_at_0, const char* source) {
    auto q = quantity("work_of_adhesion", "W_app", predicted.estimate, "J/m2");
    q.source = source;
    Json json;
    add(json, q);
    auto floored = quantity("work_of_adhesion_floored", "max(0, W_app)", floored_at_0, "J/m2");
    floored.source = source;
    add(json, floored);
    json["conforms"] = predicted.work.conforms;
    return json;
}

/// Wavelength at which the cumulative share first reaches one half.
double half_wavelength(const adhesion::ScaleBalance& scales) {
    for (Index i = 0; i < scales.wavevector.size(); ++i)
        if (scales.stored_share[i] >= 0.5) return 2.0 * pi / scales.wavevector[i];
    return undefined;
}

Quantity predicted_loss(const Estimate& loss) {
    auto q = quantity("predicted_energy_loss", "W_int A_true", loss, "J");
    q.source = "[D19] (10) at W_int of the predictions and the contact area at maximum preload";
    return q;
}

Json drawn_json(const adhesion::DrawnValue& drawn, const adhesion::BalanceDraws& draws) {
    const auto interval = [](const Interval& i) {
        return Json{{"lower", number(i.lower)}, {"upper", number(i.upper)}, {"level", i.level}};
    };
    return {{"draws", draws.count},
            {"seed", draws.seed},
            {"standard_error", number(drawn.standard_error)},
            {"interval", interval(drawn.interval)},
            {"unit", "J/m2"}};
}

/// A measured value, its standard error that of own noise and scatter, beside what inputs that loops share add to it.
Json measured_json(const Quantity& value, const Components& inputs) {
    auto json = to_json(value);
    const double noise = value.estimate.standard_error, shared = std::sqrt(covariance(inputs, inputs));
    json["standard_error_budget"] = {{"own_noise", number(noise)},
                                     {"shared_inputs", number(shared)},
                                     {"all", number(std::hypot(noise, shared))},
                                     {"unit", value.unit}};
    return json;
}

Json pair_work_along_json(const study::PairWorkAlong& along) {
    Json json{{"loops", along.loops}};
    add(json, quantity("work_at_pull_off", "W_ret(a_po)", along.at_pull_off, "J/m2"));
    add(json, quantity("work_at_largest_contact", "W_ret(a_max)", along.at_largest_contact, "J/m2"));
    add(json, quantity("slope", "dW_ret/da", along.slope, "J/m3"));
    add(json, quantity("energy_loss", "E_loss", along.energy_loss, "J"));
    add(json, quantity("energy_loss_recorded", "E_loss", along.energy_recorded, "J"));
    return json;
}

Json pair_json(const study::PairResult& pair, const adhesion::BalanceDraws& draws) {
    Json json{{"surface", pair.surface}, {"elastomer", pair.elastomer}, {"experiments", pair.experiments}};
    Json measured;
    const auto add_measured = [&](const char* name, const char* symbol, const std::optional<Estimate>& value,
                                  const Components& inputs, const char* unit) {
        measured[name] = value ? measured_json(quantity(name, symbol, *value, unit), inputs) : Json(nullptr);
    };
    add_measured("work_of_adhesion_approach", "W_app", pair.approach, pair.approach_inputs, "J/m2");
    add_measured("work_of_adhesion_pull_off", "W_po", pair.pull_off, pair.pull_off_inputs, "J/m2");
    add_measured("work_of_adhesion_retraction", "W_ret", pair.retraction, pair.retraction_inputs, "J/m2");
    add_measured("energy_loss", "E_loss", pair.loss, pair.loss_inputs, "J");
    measured["contact_area"] =
        pair.contact_area ? to_json(quantity("contact_area", "pi a_max^2", *pair.contact_area, "m2")) : Json(nullptr);
    measured["ideal_smooth_sphere_loss"] =
        pair.ideal_loss ? to_json(quantity("ideal_smooth_sphere_loss", "E_ideal", *pair.ideal_loss, "J"))
                        : Json(nullptr);
    if (pair.reference_share) {
        auto share = quantity("reference_share", "(W_ret - W_app)_smooth/(W_ret - W_app)", *pair.reference_share, "1");
        share.source = "share of the hysteresis that the smooth reference has, too";
        measured["reference_share"] = to_json(share);
    }
    add_outcome(measured, "work_along_retraction", pair.work_along_retraction, pair_work_along_json);
    json["measured"] = measured;
    if (pair.modified) {
        add(json, named("true_area_ratio", "A_true/A_app", pair.area_ratio, "1", "[D19] (9)"));
        add(json, quantity("stored_energy", "U_el/A_app", pair.stored_energy, "J/m2"));
        json["modified"] = predicted_json(*pair.modified, pair.modified->estimate, "[D19] (7)");
        if (pair.drawn) json["modified"]["draws"] = drawn_json(*pair.drawn, draws);
        json["modified"]["standard_error_budget"] = {{"spectrum", number(pair.budget->spectrum)},
                                                     {"modulus", number(pair.budget->modulus)},
                                                     {"surface_energy", number(pair.budget->surface_energy)},
                                                     {"work_of_adhesion", number(pair.budget->work_of_adhesion)},
                                                     {"unit", "J/m2"}};
        json["predicted_energy_loss"] =
            pair.predicted_loss ? to_json(predicted_loss(pair.predicted_loss->estimate())) : Json(nullptr);
        json["persson_tosatti"] =
            predicted_json(*pair.persson_tosatti, {.value = pair.persson_tosatti->work.floored}, "[D19] (S13)");
        json["without_area_change"] =
            predicted_json(*pair.without_area_change, {.value = pair.without_area_change->work.floored}, "[D19] (2)");
        json["answers"] = to_json(study::contact_answers(pair));
        json["partial_contact"] = {{"area_fraction", number(pair.contact.area_fraction)},
                                   {"work_of_adhesion", to_json(quantity("work_of_adhesion", "W_app",
                                                                         pair.partial_contact->estimate(), "J/m2"))}};
        if (pair.general)
            json["general"] = to_json(named("work_of_adhesion", "W_app", pair.general->raw, "J/m2",
                                            "of end states, or [D19] (5), (6) where form = printed"));
        if (pair.approach)
            add(json, named("residual", "W_app - max(0, (7))", pair.approach->value - pair.modified->work.floored,
                            "J/m2", "measured minus predicted"));
        add(json, named("wavelength_of_half_the_stored_energy", "lambda_1/2", half_wavelength(*pair.scales), "m",
                        "longer wavelengths store half of U_el"));
        const auto band = [](const std::optional<Band>& found) {
            return found ? Json{{"lower", number(found->lower)}, {"upper", number(found->upper)}, {"unit", "1/m"}}
                         : Json(nullptr);
        };
        json["bridging"] = band(pair.scales->bridging);
        json["pressed"] = band(pair.scales->pressed);
        json["closing"] = name(pair.closing());
        add(json, named("closing_pressure", "p", pair.scales->closing_pressure[0], "Pa",
                        "closes 99 % of patches of the same energies and rms height"));
        add(json, named("energy_in_contact", "U/U_el", pair.seen.energy, "1",
                        "stored energy of the waves within the contact, in a layer, over that of all on a half-space"));
    }
    if (pair.with_unmeasured_waves) add(json, unmeasured_quantity(*pair.with_unmeasured_waves));
    if (pair.loop)
        for (const auto& q : loop_quantities(*pair.loop)) add(json["loop"], q);
    json["alerts"] = to_json(pair.alerts);
    return json;
}

Json pairs_json(const study::Conclusions& result) {
    Json pairs = Json::array();
    for (const auto& pair : result.pairs) pairs.push_back(pair_json(pair, result.draws));
    return pairs;
}

Json equivalence_json(const statistics::Equivalence& test) {
    Json json{{"margin", number(test.margin)},
              {"probability", number(test.probability)},
              {"verdict", statistics::name(test.verdict)},
              {"source", "two one-sided tests, Schuirmann 1987"},
              {"unit", "J/m2"}};
    json["interval"] = test.interval ? Json{{"lower", number(test.interval->lower)},
                                            {"upper", number(test.interval->upper)},
                                            {"level", test.interval->level}}
                                     : Json(nullptr);
    return json;
}

Json reference_json(const study::ReferenceResult& reference) {
    Json json{{"elastomer", reference.elastomer}, {"stage", reference.stage}};
    add(json, quantity("work_of_adhesion_approach", "W_app", reference.approach, "J/m2"));
    add(json, quantity("work_of_adhesion_retraction", "W_ret", reference.retraction, "J/m2"));
    if (reference.excess_energy) add(json, quantity("excess_energy", "E_excess", *reference.excess_energy, "J"));
    if (reference.ideal_loss) add(json, quantity("ideal_smooth_sphere_loss", "E_ideal", *reference.ideal_loss, "J"));
    if (reference.loss_ratio) add(json, quantity("loss_ratio", "E_loss/E_excess", *reference.loss_ratio, "1"));
    if (reference.contact_area) add(json, quantity("contact_area", "pi a_max^2", *reference.contact_area, "m2"));
    add(json, quantity("hysteresis", "W_ret - W_app", reference.hysteresis.difference, "J/m2"));
    json["hysteresis_test"] = equivalence_json(reference.hysteresis);
    if (const auto& loss = reference.loss_per_area) {
        add(json, quantity("loss_per_area", "(E_excess - E_ideal)/(pi a_max^2)", loss->difference, "J/m2"));
        json["loss_per_area_test"] = equivalence_json(*loss);
    }
    return json;
}

Json drift_json(const study::ReferenceDrift& drift) {
    Json json{{"elastomer", drift.elastomer}};
    add(json, quantity("work_of_adhesion_approach_change", "dW_app", drift.change.work_of_adhesion_loading, "J/m2"));
    add(json,
        quantity("work_of_adhesion_retraction_change", "dW_ret", drift.change.work_of_adhesion_retraction, "J/m2"));
    add(json, quantity("excess_energy_change", "dE_excess", drift.change.excess_energy, "J"));
    return json;
}

Json cutoff_json(const study::CutoffPoint& point, const study::StudyResult& result) {
    Json json;
    add(json, quantity("shortest_wavelength", "lambda_s", point.shortest_wavelength, "m"));
    const auto fit = [](const adhesion::WorkFit& f) {
        Json inner;
        add(inner, quantity("work_of_adhesion", "W_int", f.work_of_adhesion, "J/m2"));
        add(inner, quantity("r_squared", "R2", f.r_squared, "1"));
        inner["generalised"] = to_json(quantity("work_of_adhesion", "W_int", f.generalised.estimate(), "J/m2"));
        inner["log_likelihood"] = number(f.generalised.log_likelihood);
        return inner;
    };
    json["modified"] = fit(point.modified);
    json["persson_tosatti"] = fit(point.persson_tosatti);
    for (std::size_t i = 0; i < result.surfaces.size(); ++i) {
        Json surface;
        add(surface, quantity("rms_slope", "h'_rms", point.surfaces[i].rms_slope, "1"));
        add(surface,
            quantity("elastic_energy_per_modulus", "U_el/(A E*)", point.surfaces[i].elastic_energy_per_modulus, "m"));
        json["surfaces"][result.surfaces[i].name] = surface;
    }
    return json;
}

Json cutoffs_json(const study::StudyResult& result, const study::Conclusions& conclusions) {
    Json scan = Json::array();
    for (const auto& point : conclusions.cutoff_scan) scan.push_back(cutoff_json(point, result));
    return scan;
}

/// ln L against the best of all.
Json balances_json(const study::Conclusions& conclusions) {
    Json all = Json::array();
    double best = -std::numeric_limits<double>::infinity();
    for (const auto& b : conclusions.balances) best = std::max(best, b.score.log_likelihood);
    for (const auto& b : conclusions.balances) {
        Json json{{"balance", b.balance}, {"n", b.score.n}, {"parameters", b.score.parameters}};
        if (b.shortest_wavelength > 0.0)
            add(json, quantity("shortest_wavelength", "lambda_s", b.shortest_wavelength, "m"));
        add(json, quantity("surface_energy_factor", "gamma1/gamma1", b.surface_energy_factor, "1"));
        add(json, quantity("work_of_adhesion", "W_int", b.score.work_of_adhesion, "J/m2"));
        add(json, quantity("r_squared", "R2", b.score.r_squared, "1"));
        add(json, quantity("log_likelihood_difference", "ln L - max", b.score.log_likelihood - best, "1"));
        add(json, quantity("left_out_deviation", "s_out", b.score.left_out_deviation, "J/m2"));
        all.push_back(json);
    }
    return all;
}

/// W_int of the predictions, or why there is none.
void add_work(Json& json, const study::Conclusions& result) {
    json["work_of_adhesion"] = nullptr;
    if (!result.work_of_adhesion) {
        json["work_of_adhesion_reason"] = result.work_of_adhesion.reason;
        return;
    }
    auto work = quantity("work_of_adhesion", "W_int", *result.work_of_adhesion, "J/m2");
    work.source = result.work_of_adhesion_source;
    json["work_of_adhesion"] = to_json(work);
    if (result.draws.work_of_adhesion)
        json["work_of_adhesion_draws"] = drawn_json(*result.draws.work_of_adhesion, result.draws);
}

/// What quoted numbers rest on, how well each pair is predicted by the others, and what the pairs say of inputs.
void add_budgets(Json& json, const study::Conclusions& result) {
    json["budgets"] = budgets_json(result);
    json["left_out"] = left_out_json(result);
    json["profiles"] = profiles_json(result);
}

Json replicates_json(const study::ElastomerReplicates& replicates) {
    Json json{
        {"elastomer", replicates.elastomer}, {"quantity", replicates.data.quantity}, {"symbol", replicates.symbol}};
    if (!replicates.model) {
        json["reason"] = replicates.model.reason;
        json["rows"] = rows_json(replicates.data);
        return json;
    }
    json.update(to_json(replicates.data, *replicates.model));
    return json;
}

Json prediction_json(const adhesion::PredictionTest& test) {
    Json json{{"work_of_adhesion_fitted_to_them", test.work_fitted},
              {"pairs", Json::array()},
              {"left_out", test.left_out},
              {"n", test.n},
              {"degrees_of_freedom", test.degrees_of_freedom}};
    add(json, named("chi_squared", "chi2", test.chi_squared, "1",
                    "r' C^-1 r with the covariance of measured and predicted values"));
    json["probability"] = number(test.probability);
    add(json, named("extra_scatter", "tau", test.extra_scatter, "J/m2",
                    "scatter of the model with which chi2 is its degrees of freedom"));
    add(json, quantity("chi_squared_with_scatter", "chi2", test.chi_squared_with_scatter, "1"));
    json["probability_with_scatter"] = number(test.probability_with_scatter);
    for (const auto& pair : test.pairs) {
        Json entry{{"surface", pair.surface}, {"elastomer", pair.elastomer}};
        add(entry, quantity("measured", "W_app", pair.measured, "J/m2"));
        add(entry, quantity("predicted", "max(0, (7))", pair.predicted, "J/m2"));
        add(entry,
            quantity("residual", "measured - predicted",
                     {.value = pair.residual, .standard_error = pair.standard_error, .method = "delta"}, "J/m2"));
        add(entry, quantity("standardised_residual", "residual/standard error", pair.standardised(), "1"));
        json["pairs"].push_back(std::move(entry));
    }
    return json;
}

/// What rests on surfaces, once more with their averages.
Json by_average_json(const study::StudyResult& result) {
    const auto& by_average = *result.by_average;
    Json json;
    add_work(json, by_average);
    add_budgets(json, by_average);
    json["fits"] = fits_json(by_average);
    json["pairs"] = pairs_json(by_average);
    add_outcome(json, "prediction_test", by_average.prediction_test, prediction_json);
    json["cutoff_scan"] = cutoffs_json(result, by_average);
    json["balances"] = balances_json(by_average);
    return json;
}

const adhesion::WorkFit* fit_of(const study::Conclusions& result, const std::string& fit) {
    if (fit == "modified" && result.modified) return &*result.modified;
    if (fit == "persson_tosatti" && result.persson_tosatti) return &*result.persson_tosatti;
    if (fit == "loop" && result.loop) return &result.loop->through_origin;
    return nullptr;
}

Json input_json(const study::InputFile& input) {
    return {{"file", input.path},
            {"size", {{"value", input.size}, {"unit", "byte"}}},
            {"sha256", input.sha256.empty() ? Json(nullptr) : Json(input.sha256)}};
}

Json reported_json(const study::ReportedValue& reported, const study::StudyResult& result) {
    const auto* fit = fit_of(result, reported.fit);
    const bool work = reported.quantity == "work_of_adhesion";
    const char* unit = work ? "J/m2" : "1";
    auto theirs = quantity(reported.quantity, work ? "W_int" : "R2", reported.value, unit);
    theirs.source = reported.source;
    return {{"fit", reported.fit},
            {"reported", to_json(theirs)},
            {"here", fit ? to_json(quantity(reported.quantity, work ? "W_int" : "R2",
                                            work ? fit->work_of_adhesion.value : fit->r_squared, unit))
                         : Json(nullptr)}};
}

Json experiment_json(const study::ExperimentResult& e) {
    Json entry{{"file", e.input.file},
               {"surface", e.input.surface},
               {"elastomer", e.input.elastomer},
               {"role", e.input.reference ? "reference" : "rough"}};
    if (!e.input.lens.empty()) entry["lens"] = e.input.lens;
    if (!e.input.spot.empty()) entry["spot"] = e.input.spot;
    if (e.input.excluded()) entry["excluded"] = e.input.exclusion;
    if (e.failed()) entry["error"] = e.error;
    entry["analysis"] = e.analysis ? to_json(*e.analysis) : Json(nullptr);
    if (e.models) entry["models"] = to_json(*e.models);
    return entry;
}

/// All but the lists of which there may be thousands: those are empty.
Json frame_json(const study::StudyResult& result) {
    const auto& study = result.study;
    Json json{{"title", study.title}, {"description", study.description}};
    const auto said = verdict(result);
    json["verdict"] = {{"answer", said.answer}, {"findings", said.findings}, {"limits", said.limits}};
    add_work(json, result);
    add_budgets(json, result);
    json["fits"] = fits_json(result);
    json["surfaces"] = Json::object();
    json["elastomers"] = Json::object();
    for (const auto& elastomer : result.elastomers)
        json["elastomers"][elastomer.input.name] = elastomer_json(elastomer);
    json["pairs"] = Json::array();
    add_outcome(json, "prediction_test", result.prediction_test, prediction_json);
    add_outcome(json, "hysteresis", result.hysteresis, [](const study::Hysteresis& h) { return to_json(h); });
    json["replicates"] = Json::array();
    for (const auto& replicates : result.replicates) json["replicates"].push_back(replicates_json(replicates));
    if (result.by_average) json["by_average"] = by_average_json(result);
    json["experiments"] = Json::array();
    json["references"] = Json::array();
    for (const auto& reference : result.references) json["references"].push_back(reference_json(reference));
    json["reference_changes"] = Json::array();
    for (const auto& drift : result.reference_drifts) json["reference_changes"].push_back(drift_json(drift));
    json["cutoff_scan"] = cutoffs_json(result, result);
    json["balances"] = balances_json(result);
    json["loss_slope_of_works"] = nullptr;
    if (const auto& slope = result.loss_slope_of_works) {
        auto work = quantity("work_per_true_area", "E_loss/A_true", slope->work_per_true_area, "J/m2");
        work.n = slope->pairs;
        work.source = "loops with the measured W_app and W_ret, through the origin";
        json["loss_slope_of_works"] = to_json(work);
    }
    json["reported"] = Json::array();
    for (const auto& reported : study.reported) json["reported"].push_back(reported_json(reported, result));
    json["alerts"] = Json::array();
    json["provenance"] = {{"program", "setae"}, {"version", study::version()}, {"inputs", Json::array()}};
    return json;
}

/// A surface without its measurements: their list is empty.
Json surface_frame(const study::SurfaceResult& surface, const study::SurfaceAnalysisOptions& options) {
    Json json;
    if (surface.failed()) {
        json["error"] = surface.error;
    } else {
        json = spectrum_json(surface, surface.used(), options);
        json["spectrum_method"] = study::method_name(surface, surface.method);
        if (surface.likelihood)
            for (const auto& [method, spectrum] : study::spectra_of(surface))
                json["spectra"][method] = spectrum_json(surface, *spectrum, options);
        if (surface.fitted) json["likelihood"] = to_json(*surface.fitted);
        if (!surface.likelihood_error.empty()) json["likelihood_error"] = surface.likelihood_error;
        json["reconstructed"] = surface.reconstructed;
        json["n_measurements"] = surface.measurements.size();
    }
    json["measurements"] = Json::array();
    if (surface.beyond_data) json["beyond_data"] = continuation_json(*surface.beyond_data);
    if (surface.longer_waves) json["longer_waves"] = continuation_json(*surface.longer_waves);
    json["alerts"] = to_json(surface.alerts);
    return json;
}

/// An array of whose items there may be thousands.
struct List {
    std::size_t size = 0;
    std::function<Json(std::size_t)> item;

    void fill(Json& array, std::size_t most) const {
        for (std::size_t i = 0; i < std::min(size, most); ++i) array.push_back(item(i));
    }
};

List measurements_of(const study::SurfaceResult& surface) {
    return {surface.measurements.size(), [&](std::size_t i) { return measurement_json(surface.measurements[i]); }};
}

List inputs_of(const study::StudyResult& result) {
    return {result.inputs.size(), [&](std::size_t i) { return input_json(result.inputs[i]); }};
}

/// The arrays of a study that frame_json() leaves empty, but that of the inputs.
std::map<std::string, List> lists_of(const study::StudyResult& result) {
    return {{"pairs", {result.pairs.size(), [&](std::size_t i) { return pair_json(result.pairs[i], result.draws); }}},
            {"experiments",
             {result.experiments.size(), [&](std::size_t i) { return experiment_json(result.experiments[i]); }}},
            {"alerts", {result.alerts.size(), [&](std::size_t i) { return described(result.alerts[i]); }}}};
}

/// A surface as a study has it, without measurements: `stem` names the file of its spectrum.
Json named_frame(const study::SurfaceResult& surface, const std::string& stem,
                 const study::SurfaceAnalysisOptions& options) {
    auto json = surface_frame(surface, options);
    if (!surface.failed()) json["spectrum_file"] = "psd_" + stem + ".csv";
    return json;
}

/// How many entries of a study's lists are wanted.
struct Wanted {
    std::size_t entries = std::numeric_limits<std::size_t>::max();
    std::size_t experiments = entries;
};

/// A study with the first entries of its lists, and of each surface's measurements.
Json study_json(const study::StudyResult& result, const Wanted& most) {
    auto json = frame_json(result);
    const auto stems = spectrum_stems(result);
    for (std::size_t i = 0; i < std::min(most.entries, stems.size()); ++i) {
        const auto& surface = result.surfaces[i];
        auto& entry = json["surfaces"][surface.name] = named_frame(surface, stems[i], result.study.analysis);
        measurements_of(surface).fill(entry["measurements"], most.entries);
    }
    for (const auto& [key, list] : lists_of(result))
        list.fill(json[key], key == "experiments" ? most.experiments : most.entries);
    inputs_of(result).fill(json["provenance"]["inputs"], most.entries);
    return json;
}

/// Without long columns of numbers, and so many objects of longer lists.
Json without_curves(const Json& json, std::size_t most) {
    constexpr std::size_t longest = 16;
    if (json.is_array()) {
        if (json.size() > longest &&
            std::all_of(json.begin(), json.end(), [](const Json& item) { return item.is_number() || item.is_null(); }))
            return nullptr;
        Json copy = Json::array();
        for (const auto& item : json) {
            if (copy.size() == most && item.is_object()) break;
            copy.push_back(without_curves(item, most));
        }
        return copy;
    }
    if (!json.is_object()) return json;
    Json copy = Json::object();
    for (const auto& [key, item] : json.items()) copy[key] = without_curves(item, most);
    return copy;
}

/// Writes a list's items, some at a time, each made on a thread of its own: thousands would not fit into memory.
void write_list(const List& list, JsonWriter& writer) {
    constexpr std::size_t at_once = 32;
    writer.begin_array();
    for (std::size_t first = 0; first < list.size; first += at_once) {
        std::vector<std::string> texts(std::min(at_once, list.size - first));
        parallel::for_each_index(texts.size(), {}, [&](std::size_t i) {
            texts[i] = JsonWriter::text_within(writer.depth(), list.item(first + i));
        });
        for (const auto& text : texts) writer.element_as(text);
    }
    writer.end_array();
}

/// Writes an object whose entry `key` is a list.
void write_with_list(const Json& json, const char* key, const List& list, JsonWriter& writer) {
    writer.begin_object();
    for (const auto& [name, value] : json.items()) {
        writer.key(name);
        if (name == key) write_list(list, writer);
        else writer.value(value);
    }
    writer.end_object();
}

void write_surfaces(const study::StudyResult& result, JsonWriter& writer) {
    const auto stems = spectrum_stems(result);
    writer.begin_object();
    for (std::size_t i = 0; i < stems.size(); ++i) {
        const auto& surface = result.surfaces[i];
        writer.key(surface.name);
        write_with_list(named_frame(surface, stems[i], result.study.analysis), "measurements", measurements_of(surface),
                        writer);
    }
    writer.end_object();
}

}  // namespace

Json to_json(const study::SurfaceResult& surface, const study::SurfaceAnalysisOptions& options) {
    auto json = surface_frame(surface, options);
    measurements_of(surface).fill(json["measurements"], surface.measurements.size());
    return json;
}

Json to_json(const study::StudyResult& result) { return study_json(result, {}); }

Json json_without_curves(const study::StudyResult& result, std::size_t max_entries, std::size_t max_experiments) {
    return without_curves(study_json(result, {max_entries, max_experiments}), max_entries);
}

void write_json(const study::StudyResult& result, const std::function<void(std::string_view)>& write) {
    JsonWriter writer(write);
    const auto json = frame_json(result);
    const auto lists = lists_of(result);
    writer.begin_object();
    for (const auto& [key, value] : json.items()) {
        writer.key(key);
        if (key == "surfaces") write_surfaces(result, writer);
        else if (key == "provenance") write_with_list(value, "inputs", inputs_of(result), writer);
        else if (const auto list = lists.find(key); list != lists.end()) write_list(list->second, writer);
        else writer.value(value);
    }
    writer.end_object();
}

}  // namespace setae::output
