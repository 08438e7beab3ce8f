// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "pairs.hpp"
#include "setae/contact/elasticity.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/rubber.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

/// One fit of all loops on an elastomer that ask for it and are not excluded; nothing where none does.
std::optional<Outcome<loops::GlobalFit>> share(const StudyResult& result, const std::string& elastomer) {
    const LoopModelOptions* options = nullptr;
    std::vector<loops::GlobalBranch> loops;
    try {
        for (const auto& e : result.experiments) {
            if (e.input.elastomer != elastomer || e.input.excluded() || !e.input.models.shared()) continue;
            options = &e.input.models;  // the study's file says the same of all of them
            if (e.analysis && (options->branch == loops::LoopBranch::loading || e.analysis->unloading))
                loops.push_back(branch_to_share(e.input.file, *e.analysis, e.bodies, e.input.options, *options));
        }
        if (!options) return std::nullopt;
        return shared_fit(loops, *options);
    } catch (const std::exception& error) {
        return Outcome<loops::GlobalFit>::missing(reason_of(error));
    }
}

void set_modulus(ElastomerResult& elastomer, const StudyResult& result) {
    elastomer.youngs_modulus = elastomer.input.youngs_modulus;
    if (!(elastomer.youngs_modulus.value > 0.0)) {
        std::vector<Estimate> from_loops;
        for (const auto& e : result.experiments)
            if (e.analysis && !e.input.excluded() && e.input.elastomer == elastomer.input.name)
                from_loops.push_back(e.analysis->loading.primary().youngs_modulus);
        if (from_loops.empty()) return;
        elastomer.youngs_modulus = mean_of(from_loops);
        elastomer.modulus_from_loops = true;
    }
    const contact::ElasticSolid rough{result.study.counter_youngs_modulus, result.study.counter_poisson_ratio};
    const auto against_rough = [&](double modulus) {
        return contact::contact_modulus({modulus, elastomer.input.poisson_ratio}, rough);
    };
    const auto& E = elastomer.youngs_modulus;
    elastomer.contact_modulus.value = against_rough(E.value);
    // linear propagation by a central difference over the ± itself
    elastomer.contact_modulus.method = "delta";
    if (E.uncertain())
        elastomer.contact_modulus.standard_error =
            0.5 * (against_rough(E.value + E.standard_error) -
                   against_rough(std::max(1e-3 * E.value, E.value - E.standard_error)));
}

void check_plausibility(ElastomerResult& elastomer) {
    if (!elastomer.input.crosslink_molar_mass || !(elastomer.youngs_modulus.value > 0.0)) return;
    elastomer.network_modulus = loops::rubber_modulus(elastomer.input.density, elastomer.input.temperature,
                                                      *elastomer.input.crosslink_molar_mass);
    const double ratio = elastomer.youngs_modulus.value / *elastomer.network_modulus;
    constexpr double largest_ratio = 30.0;  // entanglements raise E of lightly linked networks, E = 3G alone gives 3
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
