// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "data_files.hpp"
#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/contact/elasticity.hpp"
#include "setae/core/errors.hpp"
#include "setae/laboratory/data_set.hpp"
#include "setae/laboratory/retraction_work.hpp"

namespace setae::laboratory {
namespace {

double contact_modulus(const Recipe& recipe, const ElastomerRecipe& elastomer) {
    return contact::contact_modulus({.youngs_modulus = elastomer.youngs_modulus, .poisson_ratio = elastomer.poisson_ratio},
                                    {.youngs_modulus = recipe.counter_youngs_modulus, .poisson_ratio = recipe.counter_poisson_ratio});
}

double work_retraction(const Recipe& recipe, const LoopSpecimen& specimen, const SurfaceTruth& surface, double stored_energy) {
    const LoopRecipe& loops = *recipe.loops;
    if (loops.law == RetractionLaw::pinning)
        return work_retraction_by_pinning({.work_approach = specimen.work_approach,
                                           .mean_work = recipe.work_of_adhesion,
                                           .stored_energy = stored_energy});
    const double area = loop_truth(specimen, loops.protocol).largest_contact_area();
    return work_retraction_for_loss(specimen, loops.protocol, loops.loss_factor * recipe.work_of_adhesion * surface.area_ratio * area);
}

LoopSpecimen rough_specimen(const Recipe& recipe, const SurfaceTruth& surface, const ElastomerRecipe& elastomer) {
    LoopSpecimen specimen{.radius = elastomer.sphere_radius, .contact_modulus = contact_modulus(recipe, elastomer)};
    const double stored_energy = specimen.contact_modulus * surface.parameters.elastic_energy_per_modulus;
    const auto work = adhesion::modified_balance(recipe.work_of_adhesion, elastomer.surface_energy.value,
                                                 {.area_ratio = surface.area_ratio, .stored_energy = stored_energy});
    if (!work.conforms)
        throw InvalidArgument(fmt::format("(7) gives W_app = {:.3g} mJ/m2, so the bodies would not conform; take a softer elastomer, a "
                                          "smoother surface or a larger work of adhesion", 1e3 * work.raw));
    specimen.work_approach = specimen.work_retraction = work.raw;
    specimen.work_retraction = work_retraction(recipe, specimen, surface, stored_energy);
    return specimen;
}

}  // namespace

std::vector<PlantedLoop> planted_loops(const Recipe& recipe) {
    std::vector<PlantedLoop> loops;
    if (!recipe.loops) return loops;
    const auto add = [&](PlantedLoop loop) {
        loop.truth = loop_truth(loop.specimen, recipe.loops->protocol);
        loops.push_back(std::move(loop));
    };
    for (const auto& rough : recipe.surfaces) {
        const SurfaceTruth surface = surface_truth(rough.surface);
        for (const auto& elastomer : recipe.elastomers) try {
                add({.file = fmt::format("loops/{}_{}.csv", file_stem(rough.surface.name), file_stem(elastomer.name)),
                     .surface = rough.surface.name,
                     .elastomer = elastomer.name,
                     .specimen = rough_specimen(recipe, surface, elastomer)});
            } catch (const InvalidArgument& error) {
                throw InvalidArgument(fmt::format("surface {} on elastomer {}: {}", rough.surface.name, elastomer.name, error.what()));
            }
    }
    if (const auto& work = recipe.loops->reference_work)
        for (const auto& elastomer : recipe.elastomers)
            for (const char* stage : {"before", "after"})
                add({.file = fmt::format("loops/reference_{}_{}.csv", file_stem(elastomer.name), stage),
                     .elastomer = elastomer.name,
                     .stage = stage,
                     .specimen = {.radius = elastomer.sphere_radius,
                                  .contact_modulus = contact_modulus(recipe, elastomer),
                                  .work_approach = *work,
                                  .work_retraction = *work}});
    return loops;
}

}  // namespace setae::laboratory
