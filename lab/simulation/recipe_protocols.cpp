// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipe_protocols.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::simulation {
namespace {

using bytes::TomlReader;

constexpr Index max_pixels = 2048;

/// A length that is not negative.
void take(TomlReader& reader, const char* key, double& value) {
    const auto given = reader.quantity(key, dimension::length);
    if (!given) return;
    if (!(*given >= 0.0)) reader.fail(key, fmt::format("{} m; expected a length from 0", *given));
    value = *given;
}

void take_number(TomlReader& reader, const char* key, double& value) {
    if (const auto given = reader.number(key)) value = *given;
}

std::vector<double> lengths(TomlReader& reader, const char* key) {
    const auto values = reader.quantities(key, dimension::length);
    if (values.empty()) reader.fail(key, "an instrument without measurements; expected a list with one length each");
    for (const double value : values)
        if (!(value > 0.0)) reader.fail(key, fmt::format("{} m; expected lengths > 0", value));
    return values;
}

/// Tip radius and its uncertainty; tip = "none" or a radius of 0 is no tip.
template <class Protocol>
void take_tip(TomlReader& reader, Protocol& protocol) {
    const auto tip = reader.text("tip");
    if (tip && *tip != "none")
        reader.fail("tip", fmt::format("'{}', expected \"none\"; a sphere has tip_radius", *tip));
    const auto radius = reader.uncertain("tip_radius", dimension::length);
    if (tip && radius) reader.fail("tip", "beside tip_radius; expected one of them");
    if (tip) protocol.tip_radius = 0.0;
    if (!radius) return;
    if (!(radius->value >= 0.0))
        reader.fail("tip_radius", fmt::format("{} m; expected a radius from 0", radius->value));
    protocol.tip_radius = radius->value;
    if (radius->standard_error > 0.0 && radius->value > 0.0)
        protocol.tip_radius_standard_error = radius->standard_error;
}

void require_one_each(TomlReader& reader, const char* key, std::size_t values, std::size_t measurements) {
    if (values != 1 && values != measurements)
        reader.fail(key, fmt::format("{} values for {} measurements; expected one, or one each", values, measurements));
}

StylusProtocol read_stylus(TomlReader reader) {
    StylusProtocol protocol{.lengths = lengths(reader, "lengths")};
    if (reader.is_list("step")) protocol.steps = lengths(reader, "step");
    else take(reader, "step", protocol.steps.front());
    require_one_each(reader, "step", protocol.steps.size(), protocol.lengths.size());
    for (std::size_t k = 0; k < protocol.lengths.size(); ++k)
        if (!(protocol.step(k) > 0.0) || !(protocol.lengths[k] >= 2.0 * protocol.step(k)))
            reader.fail("step", fmt::format("{} m for a scan of {} m; expected 0 < step <= length/2", protocol.step(k),
                                            protocol.lengths[k]));
    take_tip(reader, protocol);
    take(reader, "noise", protocol.noise);
    if (const auto bow = reader.quantity("bow", dimension::length)) protocol.bow = *bow;
    take_number(reader, "tilt", protocol.tilt);
    take(reader, "artefact", protocol.artefact);
    take(reader, "artefact_wavelength", protocol.artefact_wavelength);
    if (!(protocol.artefact_wavelength > 0.0)) reader.fail("artefact_wavelength", "0 m; expected a length > 0");
    reader.finish();
    return protocol;
}

AfmProtocol read_afm(TomlReader reader) {
    AfmProtocol protocol{.sizes = lengths(reader, "sizes")};
    if (reader.is_list("pixels")) {
        protocol.pixels.clear();
        for (const double n : reader.quantities("pixels", dimension::none))
            protocol.pixels.push_back(static_cast<Index>(n));
    } else if (const auto pixels = reader.integer("pixels")) {
        protocol.pixels = {*pixels};
    }
    require_one_each(reader, "pixels", protocol.pixels.size(), protocol.sizes.size());
    for (const Index pixels : protocol.pixels)
        if (pixels < 2 || pixels > max_pixels)
            reader.fail("pixels", fmt::format("{}; expected 2 to {}", pixels, max_pixels));
    take_tip(reader, protocol);
    take(reader, "noise", protocol.noise);
    take(reader, "line_offset", protocol.line_offset);
    take(reader, "line_drift", protocol.line_drift);
    take_number(reader, "tilt", protocol.tilt);
    if (const auto bow = reader.quantity("bow", dimension::length)) protocol.bow = *bow;
    take(reader, "feedback_lag", protocol.feedback_lag);
    reader.finish();
    return protocol;
}

TemProtocol read_tem(TomlReader reader) {
    TemProtocol protocol{.lengths = lengths(reader, "lengths")};
    take(reader, "step", protocol.step);
    if (!(protocol.step > 0.0)) reader.fail("step", "0 m; expected a length > 0");
    protocol.steps = reader
                         .choice<ContourSteps>("steps", {{"regular", ContourSteps::regular},
                                                         {"uniform", ContourSteps::uniform},
                                                         {"gamma", ContourSteps::gamma}})
                         .value_or(protocol.steps);
    take_number(reader, "step_spread", protocol.step_spread);
    if (!(protocol.step_spread >= 0.0) || !(protocol.step_spread <= widest_spread(protocol.steps)))
        reader.fail("step_spread",
                    fmt::format("{}; expected 0 to {:.4g}", protocol.step_spread, widest_spread(protocol.steps)));
    take(reader, "noise", protocol.noise);
    take(reader, "foil_thickness", protocol.foil_thickness);
    reader.finish();
    return protocol;
}

}  // namespace

Protocols read_protocols(TomlReader& recipe) {
    Protocols protocols;
    recipe.named_tables("protocols", [&](const std::string& name, TomlReader inner) {
        SurfaceRecipe& protocol = protocols[name];
        inner.table("stylus", [&](TomlReader part) { protocol.stylus = read_stylus(std::move(part)); });
        inner.table("afm", [&](TomlReader part) { protocol.afm = read_afm(std::move(part)); });
        inner.table("tem", [&](TomlReader part) { protocol.tem = read_tem(std::move(part)); });
        inner.finish();
    });
    return protocols;
}

}  // namespace setae::simulation
