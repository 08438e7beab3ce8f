// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "data_files.hpp"
#include "name_hash.hpp"
#include "setae/adhesion/partial_contact.hpp"
#include "setae/contact/elasticity.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/hysteresis/retraction_model.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::simulation {
namespace {

double contact_modulus(const Recipe& recipe, const ElastomerRecipe& elastomer) {
    return contact::contact_modulus(
        {.youngs_modulus = elastomer.youngs_modulus.value, .poisson_ratio = elastomer.poisson_ratio},
        {.youngs_modulus = recipe.counter_youngs_modulus, .poisson_ratio = recipe.counter_poisson_ratio});
}

/// Inputs of a pair's loop, or the reason for which there is none.
struct RoughPair {
    hysteresis::HystereticSphere specimen;
    std::string refusal;
};

/// W_ret for a given loss per area, or the reason for which there is none.
void lose(RoughPair& pair, const LoopRecipe& loops, double loss_per_area) {
    const hysteresis::SphereLoop least = true_loop(pair.specimen, loops.protocol);
    const double loss = loss_per_area * least.largest_contact_area();
    if (loss < least.energy_loss())
        pair.refusal = fmt::format(
            "the jumps by themselves lose {:.4g} J, more than the loop's {:.4g} J; press harder, or ask for a larger "
            "loss_factor",
            least.energy_loss(), loss);
    else
        pair.specimen.work_retraction =
            hysteresis::work_retraction_for_loss(pair.specimen, loops.protocol.pressing(), loss);
}

/// @throws InternalError for `loss`, which is none of theirs.
hysteresis::Law law_of(RetractionChoice law) {
    switch (law) {
        case RetractionChoice::pinning: return hysteresis::Law::pinning;
        case RetractionChoice::opening: return hysteresis::Law::opening_work;
        case RetractionChoice::reversible: return hysteresis::Law::reversible;
        case RetractionChoice::loss: break;
    }
    throw InternalError("E_loss = f W_int A_true is not a retraction model");
}

/// Deviation of W_app of a pair from its balance, from only the seed and the names.
double departure(const Recipe& recipe, const std::string& surface, const std::string& elastomer) {
    constexpr std::uint64_t scatter_streams = 3ull
                                              << 33;  // in addition to those of measurements, loops, ranges and inputs
    const auto stream = numerics::substream({.seed = recipe.seed}, scatter_streams);
    const auto normal = [&](const std::string& scope) {
        return numerics::normal_number(numerics::substream(stream, name_hash(scope)), 0);
    };
    const auto& scatter = recipe.loops->work_scatter;
    return scatter.pair * normal("pair " + surface + '\n' + elastomer) +
           scatter.surface * normal("surface " + surface) + scatter.elastomer * normal("elastomer " + elastomer);
}

/// λ̄ [m], weighed by U_el; 0 of a mirror.
double mean_wavelength(const roughness::SpectralParameters& p) {
    return p.rms_height > 0.0 ? crack_front::mean_wavelength(p.rms_height, p.elastic_energy_per_modulus) : 0.0;
}

/// The contact of a pair, with W_app without scatter: full as in the full-contact balance (Eq. 7), or that of simulated
/// patches.
hysteresis::PairState contact_state(const Recipe& recipe, const TrueSurfaceValues& surface,
                                    const ElastomerRecipe& elastomer, double contact_modulus) {
    hysteresis::PairState state{.area_ratio = surface.area_ratio,
                                .stored_energy = contact_modulus * surface.parameters.elastic_energy_per_modulus,
                                .work_of_adhesion = recipe.work_of_adhesion,
                                .surface_energy = elastomer.surface_energy.value,
                                .work_approach = 0.0,
                                .tip_factor = elastomer.tip_factor,
                                .mean_wavelength = mean_wavelength(surface.parameters)};
    const double gain = state.full_contact_gain();
    state.work_approach = gain - state.stored_energy;
    if (recipe.loops->contact == KnownContact::full || !(gain > 0.0)) return state;
    const auto contact = adhesion::unloaded_contact(state.stored_energy / gain);
    state.contact_fraction = contact.area_fraction;
    state.stored_energy = std::max(0.0, contact.area_fraction - contact.gain) * gain;
    state.work_approach = contact.gain * gain;
    return state;
}

/// For JKR's contact with W, the energy gained in contact.
hysteresis::EdgeLengths edge_of(const hysteresis::PairState& state, const hysteresis::HystereticSphere& specimen,
                                double maximum_force) {
    const contact::AdhesiveContact sphere{specimen.radius, specimen.contact_modulus,
                                          state.contact_fraction * state.full_contact_gain()};
    return hysteresis::edge_lengths(contact::jkr::contact_radius_at_force(maximum_force, sphere), sphere);
}

RoughPair rough_pair(const Recipe& recipe, const std::string& name, const TrueSurfaceValues& surface,
                     const ElastomerRecipe& elastomer) {
    const LoopRecipe& loops = *recipe.loops;
    RoughPair pair{
        .specimen = {.radius = elastomer.sphere_radius.value, .contact_modulus = contact_modulus(recipe, elastomer)},
        .refusal = {}};
    hysteresis::HystereticSphere& specimen = pair.specimen;
    using hysteresis::Tip;
    auto state = contact_state(recipe, surface, elastomer, specimen.contact_modulus);
    if (loops.law == RetractionChoice::pinning && state.full_contact_gain() > 0.0)
        state.edge = edge_of(state, specimen, loops.protocol_on(name).pressing().maximum_force);
    // a pinned edge is also pinned on approach
    const double pinned = loops.law == RetractionChoice::pinning && state.full_contact_gain() > 0.0
                              ? hysteresis::pinned_on_approach({hysteresis::Law::pinning, Tip::none}, state, {}, 0.0)
                              : 0.0;
    const double work = state.work_approach - pinned + departure(recipe, name, elastomer.name);
    if (!(work > 0.0)) {
        pair.refusal = fmt::format(
            "{} gives W_app = {:.3g} mJ/m2, so the bodies would not be in full contact; take a softer elastomer, a smoother "
            "surface or a larger work of adhesion",
            loops.contact == KnownContact::full ? "the full-contact balance (Eq. 7)" : "contact by patches",
            1e3 * work);
        return pair;
    }
    specimen.work_approach = specimen.work_retraction = work;
    if (loops.law == RetractionChoice::loss) {
        lose(pair, loops, loops.loss_factor * recipe.work_of_adhesion * state.true_contact());
        specimen.work_retraction *= elastomer.tip_factor;
    } else {
        const hysteresis::RetractionModel model{law_of(loops.law),
                                                elastomer.tip_factor > 1.0 ? Tip::reference : Tip::none};
        state.work_approach = work;
        const auto line = hysteresis::retraction_line(model, state, {});
        specimen.work_retraction = std::max(work, line.slope * loops.opening_work + line.constant);
    }
    return pair;
}

std::string file_of(const SpecimenPair& pair, int number) {
    const auto stem = fmt::format("loops/{}_{}", file_stem(pair.surface), file_stem(pair.elastomer));
    return number == 1 ? stem + ".csv" : fmt::format("{}_{}.csv", stem, number);
}

/// Called last, so that the noise of all other loops does not depend on these. Pairs without contact have none.
void add_further(std::vector<KnownLoop>& loops, const std::vector<SpecimenPair>& pairs) {
    for (const auto& pair : pairs) {
        const auto last = std::find_if(loops.rbegin(), loops.rend(), [&](const KnownLoop& loop) {
            return SpecimenPair{loop.surface, loop.elastomer} == pair;
        });
        if (last == loops.rend()) continue;
        auto next = *last;
        next.file = file_of(pair, ++next.number);
        loops.push_back(std::move(next));
    }
}

}  // namespace

std::vector<KnownLoop> known_loops(const Recipe& recipe) {
    if (!recipe.loops) return {};
    std::vector<TrueSurfaceValues> truths;
    for (const auto& rough : recipe.surfaces) truths.push_back(true_surface_values(rough.surface));
    return known_loops(recipe, truths);
}

std::vector<KnownLoop> known_loops(const Recipe& recipe, const std::vector<TrueSurfaceValues>& truths) {
    if (truths.size() != recipe.surfaces.size())
        throw InvalidArgument(
            fmt::format("true values of {} surfaces for a recipe of {}", truths.size(), recipe.surfaces.size()));
    std::vector<KnownLoop> loops;
    if (!recipe.loops) return loops;
    const auto add = [&](KnownLoop loop) {
        loop.truth = true_loop(loop.specimen, recipe.loops->protocol_on(loop.surface), loop.body);
        loops.push_back(std::move(loop));
    };
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const SurfaceRecipe& rough = recipe.surfaces[i];
        const TrueSurfaceValues& surface = truths[i];
        for (const auto& elastomer : recipe.elastomers) {
            const RoughPair pair = rough_pair(recipe, rough.surface.name, surface, elastomer);
            const SpecimenPair names{rough.surface.name, elastomer.name};
            const bool measured = !recipe.loops->is_unmeasured(names);
            if (pair.refusal.empty())
                add({.file = measured ? file_of(names, 1) : "",
                     .surface = names.surface,
                     .elastomer = names.elastomer,
                     .specimen = pair.specimen,
                     .body = elastomer.body,
                     .measured = measured});
            else if (recipe.loops->nonconforming == PairsWithoutContact::refuse)
                throw InvalidArgument(
                    fmt::format("surface {} on elastomer {}: {}; or leave such pairs out: nonconforming = \"skip\"",
                                rough.surface.name, elastomer.name, pair.refusal));
        }
    }
    if (const auto& work = recipe.loops->reference_work)
        for (const auto& elastomer : recipe.elastomers)
            for (const char* stage : {"before", "after"})
                add({.file = fmt::format("loops/reference_{}_{}.csv", file_stem(elastomer.name), stage),
                     .elastomer = elastomer.name,
                     .stage = stage,
                     .specimen = {.radius = elastomer.sphere_radius.value,
                                  .contact_modulus = contact_modulus(recipe, elastomer),
                                  .work_approach = *work,
                                  .work_retraction = elastomer.tip_factor * *work},
                     .body = elastomer.body});
    add_further(loops, recipe.loops->further);
    return loops;
}

}  // namespace setae::simulation
