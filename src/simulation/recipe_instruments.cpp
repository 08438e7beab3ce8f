// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipe_instruments.hpp"

#include <string>

namespace setae::simulation {
namespace {

using bytes::TomlReader;

/// A factor under a key; nothing without the key.
std::optional<StatedQuantity> factor(TomlReader& reader, const std::string& table, const char* key,
                                     const std::string& input, StatedDraws& stated) {
    if (!reader.contains(key)) return std::nullopt;
    return stated.required(reader, table, key, positive(dimension::none), input);
}

Calibrations read_calibrations(TomlReader reader, StatedDraws& stated) {
    Calibrations calibrations;
    const auto of_instruments = [&](const char* what, std::optional<StatedQuantity> InstrumentCalibration::* member) {
        reader.table(what, [&](TomlReader inner) {
            for (const auto& name : inner.keys())
                if (name != "stylus" && name != "afm" && name != "tem")
                    inner.fail(name.c_str(), "no instrument of a laboratory; expected stylus, afm or tem");
            const auto table = std::string("calibrations.") + what;
            const auto take = [&](const char* instrument, InstrumentCalibration& to) {
                to.*member = factor(inner, table, instrument, std::string(instrument) + "_" + what, stated);
            };
            take("stylus", calibrations.stylus);
            take("afm", calibrations.afm);
            take("tem", calibrations.tem);
        });
    };
    of_instruments("height", &InstrumentCalibration::height);
    of_instruments("lateral", &InstrumentCalibration::lateral);
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
std::optional<StatedQuantity> shared_tip(const char* name, std::optional<Protocol> SurfaceRecipe::* instrument,
                                         const TomlReader& reader, StatedDraws& stated, Recipe& recipe) {
    std::optional<StatedQuantity> tip;
    for (auto& rough : recipe.surfaces) {
        auto& protocol = rough.*instrument;
        if (!protocol || protocol->tip_radius == 0.0) continue;
        tip = stated.drawn(
            {.told = {protocol->tip_radius, protocol->tip_radius_standard_error}, .unit = "m", .input = name},
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
