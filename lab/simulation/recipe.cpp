// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/recipe.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "range_draws.hpp"
#include "recipe_elastomers.hpp"
#include "recipe_instruments.hpp"
#include "recipe_protocols.hpp"
#include "setae/core/errors.hpp"
#include "surfaces/recipe_spectrum.hpp"

namespace setae::simulation {
namespace {

using bytes::TomlReader;

constexpr Dimension frequency{{0, 0, -1, 0, 0, 0}};
constexpr Dimension speed{{1, 0, -1, 0, 0, 0}};
constexpr Dimension force_per_time{{1, 1, -3, 0, 0, 0}};
constexpr Dimension compliance = {{0, -1, 2, 0, 0, 0}};

double required(TomlReader& reader, const char* key, const Dimension& unit) {
    return reader.required_uncertain(key, unit).value;
}

void take(TomlReader& reader, const char* key, const Dimension& unit, double& value) {
    if (const auto given = reader.quantity(key, unit)) value = *given;
}

double number_or(TomlReader& reader, const char* key, double fallback) { return reader.number(key).value_or(fallback); }

SurfaceRecipe read_surface(const std::string& name, TomlReader reader, const Protocols& protocols,
                           const std::string& folder, const RangeDraws& draws) {
    const auto wanted = reader.required_text("protocol");
    const auto protocol = protocols.find(wanted);
    if (protocol == protocols.end())
        reader.fail("protocol", fmt::format("'{}' is not declared under [protocols]", wanted));
    SurfaceRecipe recipe = protocol->second;
    KnownSurface& surface = recipe.surface;
    surface.name = name;
    surface.description = reader.text("description").value_or("");
    read_spectrum(reader, folder, draws, recipe);
    reader.finish();
    return recipe;
}

void take_scatter(TomlReader& reader, const char* key, double& deviation) {
    take(reader, key, dimension::surface_energy, deviation);
    if (!(deviation >= 0.0)) reader.fail(key, "expected a standard deviation from 0, such as \"0.5 mJ/m2\"");
}

LoopRecipe read_loops(TomlReader& reader) {
    LoopRecipe loops;
    LoadingProtocol& protocol = loops.protocol;
    take(reader, "maximum_force", dimension::force, protocol.maximum_force);
    take(reader, "speed", speed, protocol.approach_speed);
    protocol.retraction_speed = protocol.approach_speed;
    take(reader, "retraction_speed", speed, protocol.retraction_speed);
    take(reader, "start_gap", dimension::length, protocol.start_gap);
    take(reader, "hold_time", dimension::time, protocol.hold_time);
    take(reader, "force_rate", frequency, protocol.force_rate);
    take(reader, "camera_rate", frequency, protocol.camera_rate);
    take(reader, "machine_stiffness", dimension::stiffness, protocol.machine_stiffness);
    LoopArtefacts& artefacts = loops.artefacts;
    take(reader, "compliance", compliance, artefacts.compliance);
    take(reader, "force_drift_rate", force_per_time, artefacts.force_drift_rate);
    take(reader, "displacement_drift_rate", speed, artefacts.displacement_drift_rate);
    take(reader, "baseline_offset", dimension::force, artefacts.baseline_offset);
    take(reader, "baseline_slope", dimension::stiffness, artefacts.baseline_slope);
    take(reader, "force_noise", dimension::force, artefacts.force_noise);
    take(reader, "displacement_noise", dimension::length, artefacts.displacement_noise);
    take(reader, "radius_noise", dimension::length, artefacts.radius_noise);
    loops.law = reader
                    .choice<RetractionChoice>("retraction", {{"loss", RetractionChoice::loss},
                                                             {"pinning", RetractionChoice::pinning},
                                                             {"opening", RetractionChoice::opening},
                                                             {"reversible", RetractionChoice::reversible}})
                    .value_or(loops.law);
    loops.contact =
        reader.choice<KnownContact>("contact", {{"full", KnownContact::full}, {"patches", KnownContact::patches}})
            .value_or(loops.contact);
    take(reader, "opening_work", dimension::surface_energy, loops.opening_work);
    if (loops.law == RetractionChoice::opening && !(loops.opening_work > 0.0))
        reader.fail("retraction", "opening needs opening_work, such as \"80 mJ/m2\"");
    loops.loss_factor = number_or(reader, "loss_factor", loops.loss_factor);
    reader.table("work_scatter", [&](TomlReader inner) {
        take_scatter(inner, "pair", loops.work_scatter.pair);
        take_scatter(inner, "surface", loops.work_scatter.surface);
        take_scatter(inner, "elastomer", loops.work_scatter.elastomer);
        inner.finish();
    });
    loops.nonconforming = reader
                              .choice<PairsWithoutContact>("nonconforming", {{"refuse", PairsWithoutContact::refuse},
                                                                             {"skip", PairsWithoutContact::skip}})
                              .value_or(loops.nonconforming);
    loops.reference_work = reader.quantity("reference_work", dimension::surface_energy);
    loops.reference_speed = reader.quantity("reference_speed", positive(speed));
    for (const auto& [key, list] : {std::pair{"unmeasured", &loops.unmeasured}, {"further", &loops.further}})
        reader.each_table(key, [list = list](TomlReader pair) {
            list->push_back({pair.required_text("surface"), pair.required_text("elastomer")});
            pair.finish();
        });
    reader.finish();
    return loops;
}

/// Shared inputs are still drawn once, but the study has a separate input at each position.
void forget_names(Recipe& recipe) {
    const auto forget = [](std::optional<StatedQuantity>& quantity) {
        if (quantity) quantity->input.clear();
    };
    auto& calibrations = recipe.calibrations;
    for (auto* instrument : {&calibrations.stylus, &calibrations.afm, &calibrations.tem}) {
        forget(instrument->height);
        forget(instrument->lateral);
    }
    for (auto* factor : {&calibrations.force, &calibrations.displacement, &calibrations.contact_radius,
                         &recipe.stylus_tip, &recipe.afm_tip})
        forget(*factor);
    for (auto& elastomer : recipe.elastomers) {
        elastomer.surface_energy.input.clear();
        elastomer.sphere_radius.input.clear();
    }
}

/// Checks that the pairs of a list are declared.
void require_declared(const std::vector<SpecimenPair>& pairs, const char* key, const Recipe& recipe,
                      const TomlReader& reader) {
    for (const auto& pair : pairs) {
        if (std::none_of(recipe.surfaces.begin(), recipe.surfaces.end(),
                         [&](const auto& rough) { return rough.surface.name == pair.surface; }))
            reader.fail(key, fmt::format("surface '{}' is not declared under [surfaces]", pair.surface));
        if (std::none_of(recipe.elastomers.begin(), recipe.elastomers.end(),
                         [&](const auto& soft) { return soft.name == pair.elastomer; }))
            reader.fail(key, fmt::format("elastomer '{}' is not declared under [elastomers]", pair.elastomer));
    }
}

/// Checks that pairs without a loop leave a loop for the modulus of every elastomer, and have no further one.
void require_consistent(const LoopRecipe& loops, const Recipe& recipe, const TomlReader& reader) {
    require_declared(loops.unmeasured, "unmeasured", recipe, reader);
    require_declared(loops.further, "further", recipe, reader);
    const auto count_of = [&](const std::string& elastomer) {
        return std::count_if(loops.unmeasured.begin(), loops.unmeasured.end(),
                             [&](const auto& pair) { return pair.elastomer == elastomer; });
    };
    for (const auto& pair : loops.unmeasured) {
        const auto soft = std::find_if(recipe.elastomers.begin(), recipe.elastomers.end(),
                                       [&](const auto& e) { return e.name == pair.elastomer; });
        if (!soft->tell_modulus && !loops.reference_work &&
            count_of(pair.elastomer) >= static_cast<std::ptrdiff_t>(recipe.surfaces.size()))
            reader.fail("unmeasured", fmt::format("leaves no loop on '{}' to take its modulus from; add tell_modulus = "
                                                  "true to [elastomers.{}]",
                                                  pair.elastomer, pair.elastomer));
    }
    for (const auto& pair : loops.further)
        if (loops.is_unmeasured(pair))
            reader.fail("further", fmt::format("{} on {} is unmeasured; expected a pair that has a loop",
                                               pair.elastomer, pair.surface));
}

}  // namespace

Recipe read_recipe(const std::string& path, std::optional<std::uint64_t> seed) {
    const auto parsed = bytes::parse_toml_file(path);
    TomlReader reader(parsed, path, "recipe");
    const std::string folder = std::filesystem::path(path).parent_path().string();
    Recipe recipe;
    recipe.title = reader.text("title").value_or("");
    recipe.description = reader.text("description").value_or("");
    if (const auto own = reader.integer("seed")) {
        if (*own < 0) reader.fail("seed", "expected a whole number from 0");
        recipe.seed = static_cast<std::uint64_t>(*own);
    }
    recipe.seed = seed.value_or(recipe.seed);
    recipe.work_of_adhesion =
        RangeDraws(recipe.seed, "").required(reader, "work_of_adhesion", dimension::surface_energy);
    if (!reader.is_table("rough_solid")) reader.fail("rough_solid", "missing: the elasticity of the rough body");
    reader.table("rough_solid", [&](TomlReader inner) {
        recipe.counter_youngs_modulus = required(inner, "youngs_modulus", dimension::pressure);
        recipe.counter_poisson_ratio = number_or(inner, "poisson_ratio", 0.0);
        inner.finish();
    });
    const Protocols protocols = read_protocols(reader);
    reader.named_tables("surfaces", [&](const std::string& name, TomlReader inner) {
        recipe.surfaces.push_back(
            read_surface(name, std::move(inner), protocols, folder, {recipe.seed, "surfaces." + name}));
    });
    StatedDraws stated(recipe.seed);
    read_instruments(reader, stated, recipe);
    reader.named_tables("elastomers", [&](const std::string& name, TomlReader inner) {
        recipe.elastomers.push_back(
            read_elastomer(name, std::move(inner), {recipe.seed, "elastomers." + name}, stated));
    });
    reader.table("loops", [&](TomlReader inner) {
        recipe.loops = read_loops(inner);
        require_consistent(*recipe.loops, recipe, inner);
    });
    if (!reader.boolean("name_inputs").value_or(true)) forget_names(recipe);
    reader.finish();
    if (recipe.surfaces.empty()) reader.fail("surfaces", "missing: expected [surfaces.NAME]");
    return recipe;
}

}  // namespace setae::simulation
