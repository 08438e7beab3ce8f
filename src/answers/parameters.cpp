// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/parameters.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace setae::answers {
namespace {

/// Spectral parameters by the conversion asked for, and by the other one.
std::vector<Quantity> spectral_quantities(const study::SurfaceResult& surface, roughness::Conversion conversion) {
    const auto named = [](std::vector<Quantity> quantities, const char* suffix) {
        for (auto& q : quantities) q.quantity += suffix;
        return quantities;
    };
    const auto& spectrum = surface.used();
    auto list = named(output::surface_quantities(surface, spectrum, conversion), "_from_spectrum");
    if (!spectrum.other_conversion) return list;
    auto other = spectrum;
    other.parameters = *spectrum.other_conversion;
    other.spread = {};
    const bool exact = conversion == roughness::Conversion::exact;
    const auto others = named(
        output::surface_quantities(surface, other, exact ? roughness::Conversion::eq11 : roughness::Conversion::exact),
        exact ? "_from_spectrum_eq11" : "_from_spectrum_exact");
    list.insert(list.end(), others.begin(), others.end());
    return list;
}

}  // namespace

Parameters parameters(const ParametersRequest& request, parallel::Threads threads) {
    const study::Wanted wanted{.previews = false, .every_measurement = request.every_measurement};
    Parameters result{.surface = study::analyse_surface(request.surface, request.analysis, wanted, threads).surface,
                      .groups = {}};
    const auto& surface = result.surface;
    if (surface.failed()) return result;
    for (const auto& m : surface.measurements)
        if (!m.failed()) result.groups.push_back({m.file, m.name, output::measurement_quantities(m), m.channel});
    ParameterGroup spectral{
        .file = "combined", .name = {}, .quantities = spectral_quantities(surface, request.analysis.conversion)};
    if (request.surface.power_spectrum) spectral.file = *request.surface.power_spectrum;
    if (surface.measurements.size() == 1) {
        spectral.file = request.surface.measurements.front().file;
        spectral.channel = surface.measurements.front().channel;
    }
    result.groups.push_back(std::move(spectral));
    return result;
}

output::Json to_json(const Parameters& parameters) {
    output::Json json = output::Json::array();
    for (const auto& group : parameters.groups) {
        for (const auto& q : group.quantities) {
            auto entry = output::to_json(q);
            entry["file"] = group.file;
            entry["measurement"] = group.name;
            if (group.channel) entry["channel"] = *group.channel;
            json.push_back(std::move(entry));
        }
    }
    return json;
}

}  // namespace setae::answers
