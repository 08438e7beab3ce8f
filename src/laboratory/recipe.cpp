// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/laboratory/recipe.hpp"

#include <cmath>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/table_file.hpp"
#include "setae/io/toml_reader.hpp"
#include "setae/synthesis/model_spectra.hpp"
#include "spectral_moment.hpp"

namespace setae::laboratory {
namespace {

using io::TomlReader;

constexpr Dimension frequency{{0, 0, -1, 0, 0, 0}};
constexpr Dimension speed{{1, 0, -1, 0, 0, 0}};
constexpr Dimension force_per_time{{1, 1, -3, 0, 0, 0}};
constexpr Dimension compliance = {{0, -1, 2, 0, 0, 0}};

double required(TomlReader& reader, const char* key, const Dimension& unit) { return reader.required_uncertain(key, unit).value; }

void take(TomlReader& reader, const char* key, const Dimension& unit, double& value) {
    if (const auto given = reader.quantity(key, unit)) value = *given;
}

double number_or(TomlReader& reader, const char* key, double fallback) { return reader.number(key).value_or(fallback); }

/// The plateau C_0 that gives the amplitude asked for, from the model with C_0 = 1.
template <class Model>
void set_plateau(TomlReader& reader, Model& model) {
    const auto height = reader.quantity("rms_height", dimension::length);
    const auto slope = reader.quantity("rms_slope", dimension::none);
    const auto plateau = reader.quantity("plateau", dimension::power_spectrum_2d);
    if (static_cast<int>(height.has_value()) + static_cast<int>(slope.has_value()) + static_cast<int>(plateau.has_value()) != 1)
        reader.fail("rms_height", "expected exactly one of rms_height, rms_slope, plateau");
    if (plateau) {
        model.plateau = *plateau;
        return;
    }
    const double order = height ? 0.0 : 2.0, wanted = height ? *height : *slope, lower = model.rolloff_wavevector;
    model.plateau = 1.0;
    const double unit = spectral_moment(synthesis::density(model), order, lower, model.short_wavevector) / (2.0 * pi);
    model.plateau = wanted * wanted / unit;
}

synthesis::SpectralDensity table_density(const std::string& path, KnownSurface& surface) {
    const Table table = io::read_table(path);
    if (table.columns.size() != 2)
        throw FormatError(path, {}, fmt::format("{} columns, expected the wavevector [1/m] and C_iso [m4]", table.columns.size()));
    const Array1D &q = table.columns[0].values, &C_iso = table.columns[1].values;
    const auto density = synthesis::tabulated_density(q, C_iso);
    surface.rolloff_wavelength = 2.0 * pi / q[0];
    surface.short_wavelength = 2.0 * pi / q[q.size() - 1];
    return density;
}

void read_spectrum(TomlReader reader, const std::string& folder, KnownSurface& surface) {
    const auto model = reader.required_text("model");
    try {
        if (model == "table") {
            surface.C_iso = table_density((std::filesystem::path(folder) / reader.required_text("file")).string(), surface);
        } else if (model == "self_affine" || model == "two_slopes") {
            surface.rolloff_wavelength = required(reader, "rolloff_wavelength", dimension::length);
            surface.short_wavelength = required(reader, "short_wavelength", dimension::length);
            const auto hurst = reader.number("hurst_exponent");
            if (!hurst) reader.fail("hurst_exponent", "missing");
            const Band band = surface.band();
            if (model == "self_affine") {
                synthesis::SelfAffine affine{.rolloff_wavevector = band.lower, .hurst_exponent = *hurst, .short_wavevector = band.upper};
                set_plateau(reader, affine);
                surface.C_iso = synthesis::density(affine);
            } else {
                synthesis::TwoSlopes slopes{.rolloff_wavevector = band.lower,
                                            .hurst_exponent = *hurst,
                                            .crossover_wavevector = 2.0 * pi / required(reader, "crossover_wavelength", dimension::length),
                                            .short_hurst_exponent = number_or(reader, "short_hurst_exponent", *hurst),
                                            .short_wavevector = band.upper};
                set_plateau(reader, slopes);
                surface.C_iso = synthesis::density(slopes);
            }
        } else {
            reader.fail("model", fmt::format("'{}', expected one of self_affine, two_slopes, table", model));
        }
    } catch (const InvalidArgument& error) {
        reader.fail("model", error.what());
    }
    reader.finish();
}

StylusProtocol read_stylus(TomlReader reader) {
    StylusProtocol protocol{.lengths = reader.quantities("lengths", dimension::length)};
    take(reader, "step", dimension::length, protocol.step);
    if (const auto tip = reader.uncertain("tip_radius", dimension::length)) {
        protocol.tip_radius = tip->value;
        if (tip->standard_error > 0.0) protocol.tip_radius_standard_error = tip->standard_error;
    }
    take(reader, "noise", dimension::length, protocol.noise);
    take(reader, "bow", dimension::length, protocol.bow);
    take(reader, "tilt", dimension::none, protocol.tilt);
    reader.finish();
    return protocol;
}

AfmProtocol read_afm(TomlReader reader) {
    AfmProtocol protocol{.sizes = reader.quantities("sizes", dimension::length)};
    if (const auto pixels = reader.integer("pixels")) protocol.pixels = *pixels;
    if (protocol.pixels < 2 || protocol.pixels > 2048) reader.fail("pixels", "expected 2 to 2048");
    if (const auto tip = reader.uncertain("tip_radius", dimension::length)) {
        protocol.tip_radius = tip->value;
        if (tip->standard_error > 0.0) protocol.tip_radius_standard_error = tip->standard_error;
    }
    take(reader, "noise", dimension::length, protocol.noise);
    take(reader, "line_offset", dimension::length, protocol.line_offset);
    reader.finish();
    return protocol;
}

TemProtocol read_tem(TomlReader reader) {
    TemProtocol protocol{.lengths = reader.quantities("lengths", dimension::length)};
    take(reader, "step", dimension::length, protocol.step);
    take(reader, "noise", dimension::length, protocol.noise);
    reader.finish();
    return protocol;
}

/// Who measures, by name: the instruments of a surface without its spectrum.
using Protocols = std::map<std::string, SurfaceRecipe>;

Protocols read_protocols(TomlReader& reader) {
    Protocols protocols;
    reader.named_tables("protocols", [&](const std::string& name, TomlReader inner) {
        SurfaceRecipe& protocol = protocols[name];
        inner.table("stylus", [&](TomlReader part) { protocol.stylus = read_stylus(std::move(part)); });
        inner.table("afm", [&](TomlReader part) { protocol.afm = read_afm(std::move(part)); });
        inner.table("tem", [&](TomlReader part) { protocol.tem = read_tem(std::move(part)); });
        inner.finish();
        const auto has_none = [](const auto& part, const auto& list) { return part && list(*part).empty(); };
        if (has_none(protocol.stylus, [](const auto& p) { return p.lengths; }) || has_none(protocol.afm, [](const auto& p) { return p.sizes; }) ||
            has_none(protocol.tem, [](const auto& p) { return p.lengths; }))
            inner.fail(name.c_str(), "an instrument without lengths or sizes; expected one a measurement");
    });
    return protocols;
}

SurfaceRecipe read_surface(const std::string& name, TomlReader reader, const Protocols& protocols, const std::string& folder) {
    const auto wanted = reader.required_text("protocol");
    const auto protocol = protocols.find(wanted);
    if (protocol == protocols.end()) reader.fail("protocol", fmt::format("'{}' is not declared under [protocols]", wanted));
    SurfaceRecipe recipe = protocol->second;
    KnownSurface& surface = recipe.surface;
    surface.name = name;
    surface.description = reader.text("description").value_or("");
    if (!reader.is_table("spectrum")) reader.fail("spectrum", "missing");
    reader.table("spectrum", [&](TomlReader inner) { read_spectrum(std::move(inner), folder, surface); });
    surface.skewness = number_or(reader, "skewness", 0.0);
    reader.finish();
    return recipe;
}

ElastomerRecipe read_elastomer(const std::string& name, TomlReader reader) {
    ElastomerRecipe elastomer{.name = name};
    elastomer.youngs_modulus = required(reader, "youngs_modulus", dimension::pressure);
    elastomer.poisson_ratio = number_or(reader, "poisson_ratio", elastomer.poisson_ratio);
    const auto energy = reader.required_uncertain("surface_energy", dimension::surface_energy);
    elastomer.surface_energy = {energy.value, energy.standard_error > 0.0 ? energy.standard_error : 0.0};
    elastomer.sphere_radius = required(reader, "sphere_radius", dimension::length);
    reader.finish();
    return elastomer;
}

LoopRecipe read_loops(TomlReader reader) {
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
    loops.law = reader.choice<RetractionLaw>("retraction", {{"loss", RetractionLaw::loss}, {"pinning", RetractionLaw::pinning}}).value_or(loops.law);
    loops.loss_factor = number_or(reader, "loss_factor", loops.loss_factor);
    loops.reference_work = reader.quantity("reference_work", dimension::surface_energy);
    reader.finish();
    return loops;
}

}  // namespace

Recipe read_recipe(const std::string& path) {
    const auto parsed = io::parse_toml_file(path);
    TomlReader reader(parsed, path, "recipe");
    const std::string folder = std::filesystem::path(path).parent_path().string();
    Recipe recipe;
    recipe.title = reader.text("title").value_or("");
    recipe.description = reader.text("description").value_or("");
    if (const auto seed = reader.integer("seed")) {
        if (*seed < 0) reader.fail("seed", "expected a whole number from 0");
        recipe.seed = static_cast<std::uint64_t>(*seed);
    }
    recipe.work_of_adhesion = required(reader, "work_of_adhesion", dimension::surface_energy);
    if (!reader.is_table("rough_solid")) reader.fail("rough_solid", "missing: the elasticity of the rough body");
    reader.table("rough_solid", [&](TomlReader inner) {
        recipe.counter_youngs_modulus = required(inner, "youngs_modulus", dimension::pressure);
        recipe.counter_poisson_ratio = number_or(inner, "poisson_ratio", 0.0);
        inner.finish();
    });
    const Protocols protocols = read_protocols(reader);
    reader.named_tables("surfaces", [&](const std::string& name, TomlReader inner) {
        recipe.surfaces.push_back(read_surface(name, std::move(inner), protocols, folder));
    });
    reader.named_tables("elastomers", [&](const std::string& name, TomlReader inner) {
        recipe.elastomers.push_back(read_elastomer(name, std::move(inner)));
    });
    reader.table("loops", [&](TomlReader inner) { recipe.loops = read_loops(std::move(inner)); });
    reader.finish();
    if (recipe.surfaces.empty()) reader.fail("surfaces", "missing: expected [surfaces.NAME]");
    return recipe;
}

}  // namespace setae::laboratory
