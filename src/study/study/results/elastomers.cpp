// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "failed_part.hpp"
#include "loop_quantities.hpp"
#include "pairs.hpp"
#include "setae/contact/elasticity.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/rubber.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

/// One fit of all loops on an elastomer that request it and are not excluded; empty where none does.
std::optional<Outcome<loops::GlobalFit>> share(const StudyResult& result, const std::string& elastomer) {
    const LoopModelOptions* options = nullptr;
    std::vector<loops::GlobalBranch> loops;
    try {
        for (const auto& e : result.experiments) {
            if (e.input.elastomer != elastomer || e.input.excluded() || !e.input.models.shared()) continue;
            options = &e.input.models;  // the study's file has equal options for all of them
            if (e.analysis && (options->branch == loops::LoopBranch::loading || e.analysis->unloading))
                loops.push_back(branch_to_share(e.input.file, *e.analysis, e.bodies, e.input.options, *options));
        }
        if (!options) return std::nullopt;
        return shared_fit(loops, *options);
    } catch (const std::exception& error) {
        return Outcome<loops::GlobalFit>::missing(reason_of(error));
    }
}

/// E/(1 − ν²) of the rough solid [Pa], which E* of no contact with it exceeds.
double rough_contact_modulus(const Study& study) {
    return study.counter_youngs_modulus / (1.0 - study.counter_poisson_ratio * study.counter_poisson_ratio);
}

/// E of the loops on an elastomer; empty where there is none.
void take_loops(ElastomerResult& elastomer, const StudyResult& result) {
    LoopsInMean loops;
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.excluded() || e.input.elastomer != elastomer.input.name) continue;
        const auto& fit = e.analysis->loading.primary();
        if (!std::isfinite(fit.youngs_modulus.value)) {
            add_failed_part(elastomer.alerts, "elastomer " + elastomer.input.name,
                            fmt::format("{} gives no E: its E* is {}, and E* of the rough solid is {}", e.input.file,
                                        format_value(fit.contact_modulus.value, "Pa", 3),
                                        format_value(rough_contact_modulus(result.study), "Pa", 3)));
            continue;
        }
        loops.loops.push_back(&e);
        loops.values.push_back(fit.youngs_modulus);
    }
    if (loops.loops.empty()) return;
    auto [mean, weights] = weighted_mean_of(loops.values);
    loops.weights = std::move(weights);
    const auto fits = fits_in_mean(loops, &FitNoise::youngs_modulus);
    const auto inputs = inputs_in_mean(loops, &LoopDependence::youngs_modulus);
    elastomer.traced_youngs_modulus = {mean.value, combined({{1.0, fits}, {1.0, inputs}})};
    if (auto rest = beyond_fits(mean, fits); rest.directions.size() > 0)
        elastomer.traced_youngs_modulus.components[loops_name(elastomer.input.name)] = std::move(rest);
    elastomer.youngs_modulus = inputs.empty() ? mean : elastomer.traced_youngs_modulus.estimate(mean.method);
    elastomer.modulus_from_loops = true;
}

/// E* of E and ν: ∂E*/∂E = (1 − ν²)(E*/E)², ∂E*/∂ν = 2ν E*²/E.
void set_contact_modulus(ElastomerResult& elastomer, const StudyResult& result) {
    const contact::ElasticSolid rough{result.study.counter_youngs_modulus, result.study.counter_poisson_ratio};
    const double E = elastomer.youngs_modulus.value, nu = elastomer.input.poisson_ratio.value;
    const TracedValue poisson_ratio(
        elastomer.input.poisson_ratio,
        input_name(elastomer.input.poisson_ratio, fmt::format("elastomers.{}.poisson_ratio", elastomer.input.name)));
    const double modulus = contact::contact_modulus({E, nu}, rough);
    elastomer.traced_contact_modulus = {
        modulus, combined({{(1.0 - nu * nu) * modulus * modulus / (E * E), elastomer.traced_youngs_modulus.components},
                           {2.0 * nu * modulus * modulus / E, poisson_ratio.components}})};
    elastomer.contact_modulus.value = modulus;
    elastomer.contact_modulus.method = "delta";
    if (!elastomer.traced_contact_modulus.components.empty())
        elastomer.contact_modulus.standard_error = elastomer.traced_contact_modulus.standard_error();
}

void set_modulus(ElastomerResult& elastomer, const StudyResult& result) {
    elastomer.youngs_modulus = elastomer.input.youngs_modulus;
    if (elastomer.youngs_modulus.value > 0.0)
        elastomer.traced_youngs_modulus = {
            elastomer.youngs_modulus,
            input_name(elastomer.youngs_modulus, fmt::format("elastomers.{}.youngs_modulus", elastomer.input.name))};
    else take_loops(elastomer, result);
    if (elastomer.youngs_modulus.value > 0.0) set_contact_modulus(elastomer, result);
}

void check_plausibility(ElastomerResult& elastomer) {
    if (!elastomer.input.crosslink_molar_mass || !(elastomer.youngs_modulus.value > 0.0)) return;
    elastomer.network_modulus = loops::rubber_modulus(elastomer.input.density, elastomer.input.temperature,
                                                      *elastomer.input.crosslink_molar_mass);
    const double ratio = elastomer.youngs_modulus.value / *elastomer.network_modulus;
    constexpr double largest_ratio = 30.0;  // entanglements increase E of lightly linked networks; only E = 3G gives 3
    if (ratio > 1.0 / largest_ratio && ratio < largest_ratio) return;
    elastomer.alerts.push_back({"MODULUS_IMPLAUSIBLE", elastomer.input.name,
                                fmt::format("E = {:.3g} Pa is {:.2g} times rho R T/M_c = {:.3g} Pa",
                                            elastomer.youngs_modulus.value, ratio, *elastomer.network_modulus),
                                "check the unit of the modulus and of the molar mass between crosslinks"});
}

}  // namespace

ElastomerResult elastomer_result(const ElastomerInput& input, const StudyResult& result) {
    ElastomerResult elastomer;
    elastomer.input = input;
    set_modulus(elastomer, result);
    elastomer.shared_fit = share(result, input.name);
    check_plausibility(elastomer);
    return elastomer;
}

}  // namespace setae::study
