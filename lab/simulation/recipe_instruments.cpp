// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipe_instruments.hpp"

#include <functional>
#include <string>
#include <utility>

namespace setae::simulation {
namespace {

using bytes::TomlReader;

/// A factor under a key; empty without the key.
std::optional<StatedQuantity> factor(TomlReader& reader, const std::string& table, const char* key,
                                     const std::string& input, StatedDraws& stated) {
    if (!reader.contains(key)) return std::nullopt;
    return stated.required(reader, table, key, positive(dimension::none), input);
}

/// Factors of the instruments under a key, by take(factor, instrument).
void of_instruments(TomlReader& reader, const char* key, StatedDraws& stated, Calibrations& calibrations,
                    const std::function<void(StatedQuantity, InstrumentCalibration&)>& take) {
    reader.table(key, [&](TomlReader inner) {
        for (const auto& name : inner.keys()) {
            auto* instrument = name == "stylus" ? &calibrations.stylus
                               : name == "afm"  ? &calibrations.afm
                               : name == "tem"  ? &calibrations.tem
                                                : nullptr;
            if (!instrument) inner.fail(name.c_str(), "no instrument of a laboratory; expected stylus, afm or tem");
            auto quantity = stated.required(inner, std::string("calibrations.") + key, name.c_str(),
                                            positive(dimension::none), name + "_" + key);
            if (instrument->height && instrument->lateral)
                inner.fail(name.c_str(), "has a scale, too; expected a scale, or a height and a lateral factor");
            take(std::move(quantity), *instrument);
        }
    });
}

Calibrations read_calibrations(TomlReader reader, StatedDraws& stated) {
    Calibrations calibrations;
    of_instruments(reader, "scale", stated, calibrations, [](StatedQuantity quantity, InstrumentCalibration& to) {
        to.height = to.lateral = std::move(quantity);
    });
    of_instruments(reader, "height", stated, calibrations,
                   [](StatedQuantity quantity, InstrumentCalibration& to) { to.height = std::move(quantity); });
    of_instruments(reader, "lateral", stated, calibrations,
                   [](StatedQuantity quantity, InstrumentCalibration& to) { to.lateral = std::move(quantity); });
    const auto of_machine = [&](const char* what, std::optional<StatedQuantity>& to) {
        to = factor(reader, "calibrations", what, std::string(what) + "_calibration", stated);
    };
    of_machine("force", calibrations.force);
    of_machine("displacement", calibrations.displacement);
    of_machine("contact_radius", calibrations.contact_radius);
    reader.finish();
    return calibrations;
}

/// One tip of an instrument for all surfaces that it measures; none where points are read without one.
template <class Protocol>
std::optional<StatedQuantity> shared_tip(const char* name, std::optional<Protocol> SurfaceRecipe::*instrument,
                                         const TomlReader& reader, StatedDraws& stated, Recipe& recipe) {
    std::optional<StatedQuantity> tip;
    for (auto& rough : recipe.surfaces) {
        auto& protocol = rough.*instrument;
        if (!protocol || protocol->tip_radius == 0.0) continue;
        tip = stated.drawn(
            {.stated_value = {protocol->tip_radius, protocol->tip_radius_standard_error}, .unit = "m", .input = name},
            "the protocol of surfaces." + rough.surface.name, reader, "shared_tips");
        protocol->shared_tip_radius = tip->value;
    }
    return tip;
}

}  // namespace

void read_instruments(TomlReader& reader, StatedDraws& stated, Recipe& recipe) {
    reader.table("calibrations",
                 [&](TomlReader inner) { recipe.calibrations = read_calibrations(std::move(inner), stated); });
    if (!reader.boolean("shared_tips").value_or(false)) return;
    recipe.stylus_tip = shared_tip("stylus_tip", &SurfaceRecipe::stylus, reader, stated, recipe);
    recipe.afm_tip = shared_tip("afm_tip", &SurfaceRecipe::afm, reader, stated, recipe);
}

}  // namespace setae::simulation
