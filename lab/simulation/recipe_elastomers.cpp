// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipe_elastomers.hpp"

#include <fmt/format.h>

namespace setae::simulation {
namespace {

using bytes::TomlReader;

/// A name that several elastomers may share; empty without one.
std::string shared_name(TomlReader& reader, const char* key) {
    const auto name = reader.text(key);
    if (name && name->empty()) reader.fail(key, "an empty text; expected a name");
    return name.value_or("");
}

StatedQuantity read_modulus(TomlReader& reader, const std::string& table, bool stated_value, const RangeDraws& ranges,
                            StatedDraws& stated) {
    constexpr const char* key = "youngs_modulus";
    if (reader.is_list(key)) {
        const double value = ranges.required(reader, key, dimension::pressure);
        return {value, {value, 0.0}, "Pa"};
    }
    auto modulus = stated.required(reader, table, key, positive(dimension::pressure));
    if (modulus.stated_value.uncertain() && !stated_value)
        reader.fail(key,
                    "a ± of a modulus that the study does not contain; add tell_modulus = true, or leave the ± out");
    return modulus;
}

double required(TomlReader& reader, const char* key, const Expected& expected, const char* example) {
    const auto given = reader.quantity(key, expected);
    if (!given) reader.fail(key, fmt::format("missing; expected {}", example));
    return *given;
}

hysteresis::EdgeSpeed read_edge_speed(TomlReader reader) {
    hysteresis::EdgeSpeed law{
        required(reader, "reference_speed", positive(dimension::length / dimension::time), "\"1 um/s\""),
        required(reader, "exponent", positive(dimension::none), "0.6")};
    reader.finish();
    return law;
}

contact::RelaxationTerm read_relaxation(TomlReader reader) {
    contact::RelaxationTerm term{required(reader, "share", non_negative(dimension::none), "0.1"),
                                 required(reader, "time", positive(dimension::time), "\"20 s\"")};
    reader.finish();
    return term;
}

void read_body(TomlReader& reader, ElastomerRecipe& elastomer) {
    reader.table("crack_speed", [&](TomlReader inner) {
        if (elastomer.tip_factor > 1.0)
            reader.fail("crack_speed", "beside tip_factor; expected one of them: both are the crack tip's loss");
        elastomer.body.edge = read_edge_speed(std::move(inner));
    });
    reader.each_table("relaxation", [&](TomlReader inner) {
        elastomer.body.relaxation.push_back(read_relaxation(std::move(inner)));
    });
}

}  // namespace

ElastomerRecipe read_elastomer(const std::string& name, TomlReader reader, const RangeDraws& ranges,
                               StatedDraws& stated) {
    const std::string table = "elastomers." + name;
    ElastomerRecipe elastomer{.name = name};
    elastomer.tell_modulus = reader.boolean("tell_modulus").value_or(elastomer.tell_modulus);
    elastomer.youngs_modulus = read_modulus(reader, table, elastomer.tell_modulus, ranges, stated);
    elastomer.poisson_ratio = reader.number("poisson_ratio").value_or(elastomer.poisson_ratio);
    if (const auto batch = shared_name(reader, "batch"); !batch.empty()) {
        elastomer.surface_energy = stated.required(reader, table, "surface_energy",
                                                   non_negative(dimension::surface_energy), "surface_energy_" + batch);
    } else {
        const auto stated_value = reader.required_uncertain("surface_energy", dimension::surface_energy);
        elastomer.surface_energy = {stated_value.value, stated_value, "J/m2"};
    }
    elastomer.sphere_radius =
        stated.required(reader, table, "sphere_radius", positive(dimension::length), shared_name(reader, "lens"));
    if (const auto factor = reader.number("tip_factor")) {
        if (!(*factor >= 1.0)) reader.fail("tip_factor", fmt::format("{}, expected 1 or more", *factor));
        elastomer.tip_factor = *factor;
    }
    read_body(reader, elastomer);
    reader.finish();
    return elastomer;
}

}  // namespace setae::simulation
