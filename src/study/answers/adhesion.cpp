// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/adhesion.hpp"

#include <limits>
#include <utility>

#include <fmt/format.h>

#include "setae/adhesion/stored_energy.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/contact_answers.hpp"
#include "setae/output/json.hpp"
#include "setae/output/predicted_quantities.hpp"

namespace setae::answers {
namespace {

/// Stored energy by the routes that the prediction does not use: Eq. 11, and for one map its own transform.
void add_other_routes(std::vector<Quantity>& list, const study::StudyResult& result,
                      const std::optional<topography::HeightMap>& map, parallel::Threads threads) {
    const double modulus = result.elastomers.front().contact_modulus.value;
    const auto& options = result.study.analysis;
    const auto add = [&](const char* name, double energy, const char* source) {
        auto q = output::quantity(name, "U_el/A_app", energy, "J/m2");
        q.source = source;
        list.push_back(std::move(q));
    };
    const bool exact = options.conversion == roughness::Conversion::exact;
    if (const auto& other = result.surfaces.front().used().other_conversion)
        add(exact ? "stored_energy_eq11" : "stored_energy_exact", modulus * other->elastic_energy_per_modulus,
            exact ? "C1D by [D19], Eq. 11" : "(E*/8) int q C1D dq");
    const auto& p = result.surfaces.front().used().parameters;
    add("stored_energy_bound", adhesion::stored_energy_bound(modulus, p.rms_height, p.rms_slope),
        "E* h_rms h'_rms/4, no spectrum with these two stores more");
    if (!map) return;
    const auto curve = roughness::limited(study::isotropic_spectrum(*map, options, threads), options.limits());
    add("stored_energy_from_C_iso", adhesion::stored_energy(modulus, curve),
        "(E*/8 pi) int q^2 C_iso dq; [D19], Eq. 8");
    add("stored_energy_from_map", adhesion::stored_energy(modulus, *map, threads),
        "(E*/4) sum |q| |h_q|^2, no isotropy assumed; all wavevectors of the map");
}

std::vector<Quantity> quantities(const study::StudyResult& result, const std::optional<topography::HeightMap>& map,
                                 parallel::Threads threads) {
    using output::quantity;
    const auto& pair = result.pairs.front();
    const auto& surface = result.surfaces.front();
    auto list = output::surface_quantities(surface, surface.used(), result.study.analysis.conversion);
    list.push_back(output::recommended_quantity(study::recommended_answer(pair)));
    list.push_back(quantity("contact_modulus", "E*", result.elastomers.front().contact_modulus, "Pa"));
    list.push_back(quantity("stored_energy", "U_el/A_app", pair.stored_energy, "J/m2"));
    add_other_routes(list, result, map, threads);
    const auto predicted = [&](const char* name, const std::optional<adhesion::PredictedWork>& work,
                               const char* source) {
        auto raw = quantity(std::string("work_of_adhesion_") + name, "W_app", work->estimate, "J/m2");
        raw.source = source;
        list.push_back(raw);
        list.push_back(quantity(std::string("work_of_adhesion_") + name + "_floored", "max(0, W_app)",
                                work->work.floored, "J/m2"));
    };
    predicted("modified", pair.modified, "[D19], Eq. 7");
    predicted("persson_tosatti", pair.persson_tosatti, "[D19], Eq. S13");
    predicted("without_area_change", pair.without_area_change, "[D19], Eq. 2");
    return list;
}

}  // namespace

study::Study AdhesionRequest::study(const study::SurfaceAnalysisOptions& analysis) const {
    if (radius.empty() != preload.empty())
        throw InvalidArgument(
            "`radius` and `preload` are given together or not at all, such as `radius = 1.25 mm` and `preload = 1 mN`");
    if (youngs_modulus.empty() || work.empty() || surface_energy.empty())
        throw InvalidArgument(
            "expected `youngs_modulus = 1.1 MPa`, `work_of_adhesion = 37 mJ/m2` and `surface_energy = 25 mJ/m2`");
    for (const double ratio : {poisson_ratio, rough_poisson_ratio})
        require_within(domain::poisson_ratio, ratio, fmt::format("{}", ratio));
    study::Study study;
    study.analysis = analysis;
    study.counter_youngs_modulus = rough_modulus.empty() ? std::numeric_limits<double>::infinity()
                                                         : parse_quantity(rough_modulus, positive(dimension::pressure));
    study.counter_poisson_ratio = rough_poisson_ratio;
    study.work_of_adhesion = parse_uncertain_quantity(work, positive(dimension::surface_energy));
    study::ElastomerInput elastomer;
    elastomer.name = "soft solid";
    elastomer.youngs_modulus = parse_uncertain_quantity(youngs_modulus, positive(dimension::pressure));
    elastomer.poisson_ratio.value = poisson_ratio;
    if (!radius.empty()) {
        elastomer.sphere_radius = parse_uncertain_quantity(radius, positive(dimension::length));
        elastomer.preload = parse_quantity(preload, non_negative(dimension::force));
    }
    elastomer.surface_energy = parse_uncertain_quantity(surface_energy, non_negative(dimension::surface_energy));
    study.elastomers = {elastomer};
    return study;
}

std::vector<Alert> Adhesion::alerts() const {
    auto alerts = alerts_of(surface());
    const auto& own = result.pairs.front().alerts;
    alerts.insert(alerts.end(), own.begin(), own.end());
    return alerts;
}

Adhesion adhesion(study::SurfaceWithMap surface, const study::SurfaceAnalysisOptions& analysis,
                  const AdhesionRequest& request, parallel::Threads threads) {
    Adhesion adhesion{.result = study::predicted_study(request.study(analysis), std::move(surface.surface)),
                      .quantities = {},
                      .answers = {}};
    auto& list = adhesion.quantities;
    list = quantities(adhesion.result, surface.map, threads);
    const auto& pair = adhesion.result.pairs.front();
    adhesion.answers = study::contact_answers(adhesion.result, pair);
    if (pair.with_unmeasured_waves) list.push_back(output::unmeasured_quantity(*pair.with_unmeasured_waves));
    if (pair.loop)
        for (auto& quantity : output::loop_quantities(*pair.loop)) list.push_back(std::move(quantity));
    return adhesion;
}

}  // namespace setae::answers
