// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/parameters.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {
namespace {

constexpr const char* of_heights =
    "of the heights as they are, all waves: to compare with other programs for maps and profiles";
constexpr const char* of_lines = "of single lines along x, each about its own mean: to compare with a profilometer";
constexpr const char* of_band = "to quote: waves of the reliable band, with ±; used for adhesion";
constexpr const char* of_other_eq11 = "to compare with publications that convert C1D by [D19], Eq. 11";
constexpr const char* of_other_exact = "exact for isotropic surfaces: to compare with the conversion asked for";

std::vector<Quantity> named(std::vector<Quantity> quantities, const char* suffix) {
    for (auto& q : quantities) q.quantity += suffix;
    return quantities;
}

/// Spectral parameters by the other conversion.
std::optional<ParameterGroup> by_other_conversion(const study::SurfaceResult& surface, const ParameterGroup& spectral,
                                                  roughness::Conversion conversion) {
    if (!surface.used().other_conversion) return std::nullopt;
    auto other = surface.used();
    other.parameters = *other.other_conversion;
    other.spread = {};
    const bool exact = conversion == roughness::Conversion::exact;
    auto group = spectral;
    group.purpose = exact ? of_other_eq11 : of_other_exact;
    group.quantities = named(
        output::surface_quantities(surface, other, exact ? roughness::Conversion::eq11 : roughness::Conversion::exact),
        exact ? "_from_spectrum_eq11" : "_from_spectrum_exact");
    return group;
}

bool is_of_lines(const Quantity& quantity) { return quantity.quantity == "rms_height_of_lines"; }

bool is_to_quote(const Quantity& quantity) {
    constexpr std::array names{"rms_height_from_spectrum", "rms_slope_from_spectrum", "rms_curvature_from_spectrum",
                               "true_area_ratio_from_spectrum"};
    return std::find(names.begin(), names.end(), quantity.quantity) != names.end();
}

/// "tilt", or "tilt (a.ibw), parabola (b.csv)" where measurements differ.
std::string levelling_of(const study::SurfaceResult& surface) {
    std::vector<std::pair<std::string, std::string>> removed;
    for (const auto& m : surface.measurements)
        if (!m.failed()) removed.emplace_back(topography::name(m.trend), m.file);
    const bool alike = std::all_of(removed.begin(), removed.end(),
                                   [&](const auto& one) { return one.first == removed.front().first; });
    if (alike) return removed.empty() ? std::string() : removed.front().first;
    std::string text;
    for (const auto& [trend, file] : removed) text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", trend, file);
    return text;
}

/// Whether one pass over the heights gives all wanted parameters. Rq and Rdq are symbols of lines and maps.
bool is_of_one_pass(const ParametersRequest& request) {
    constexpr std::array names{"rms_height",    "Sq",    "Rq",  "rms_height_of_lines",
                               "rms_slope",     "Sdq",   "Rdq", "rms_slope_x",
                               "rms_curvature", "lap/2", "Rddq"};
    return !request.only.empty() && !request.surface.power_spectrum &&
           std::all_of(request.only.begin(), request.only.end(),
                       [&](const auto& name) { return std::find(names.begin(), names.end(), name) != names.end(); });
}

/// By its symbol or its name, "areal_rms_height" also by "rms_height".
bool is_called(const Quantity& quantity, const std::string& name) {
    return quantity.symbol == name || quantity.quantity == name || quantity.quantity == "areal_" + name ||
           quantity.quantity == "profile_" + name;
}

/// Leaves only the wanted parameters. @throws InvalidArgument for a name that none has.
void keep_only(std::vector<ParameterGroup>& groups, const std::vector<std::string>& only) {
    std::string known;
    for (const auto& group : groups)
        for (const auto& q : group.quantities) known += (known.empty() ? "" : ", ") + q.quantity;
    for (const auto& name : only)
        if (std::none_of(groups.begin(), groups.end(), [&](const auto& group) {
                return std::any_of(group.quantities.begin(), group.quantities.end(),
                                   [&](const auto& q) { return is_called(q, name); });
            }))
            throw InvalidArgument(fmt::format("no parameter '{}'; expected one of {}", name, known));
    for (auto& group : groups)
        std::erase_if(group.quantities, [&](const auto& q) {
            return std::none_of(only.begin(), only.end(), [&](const auto& name) { return is_called(q, name); });
        });
}

/// Parameters of the spectrum of all measurements, by both conversions.
void add_spectral_parameters(Parameters& result, const ParametersRequest& request) {
    const auto& surface = result.surface;
    ParameterGroup spectral{
        .file = "combined",
        .name = {},
        .purpose = of_band,
        .quantities =
            named(output::surface_quantities(surface, surface.used(), request.analysis.conversion), "_from_spectrum")};
    if (request.surface.power_spectrum) spectral.file = *request.surface.power_spectrum;
    if (surface.measurements.size() == 1) {
        spectral.file = request.surface.measurements.front().file;
        spectral.channel = surface.measurements.front().channel;
    }
    std::copy_if(spectral.quantities.begin(), spectral.quantities.end(), std::back_inserter(result.headline),
                 is_to_quote);
    result.levelling = levelling_of(surface);
    auto other = by_other_conversion(surface, spectral, request.analysis.conversion);
    result.groups.push_back(std::move(spectral));
    if (other) result.groups.push_back(std::move(*other));
}

}  // namespace

Parameters parameters(const ParametersRequest& request, parallel::Threads threads) {
    const study::Wanted wanted{
        .previews = false, .spectrum = !is_of_one_pass(request), .every_measurement = request.every_measurement};
    Parameters result{.surface = study::analyse_surface(request.surface, request.analysis, wanted, threads).surface,
                      .groups = {},
                      .headline = {},
                      .levelling = {}};
    if (result.surface.failed()) return result;
    for (const auto& m : result.surface.measurements)
        if (!m.failed())
            result.groups.push_back({m.file, m.name, of_heights, output::measurement_quantities(m), m.channel});
    if (wanted.spectrum) add_spectral_parameters(result, request);
    if (!request.only.empty()) keep_only(result.groups, request.only);
    return result;
}

std::string headline_text(const Parameters& parameters) {
    std::string text;
    for (const auto& q : parameters.headline)
        text += fmt::format(
            "{}{} {}", text.empty() ? "To quote: " : ", ", q.symbol,
            q.estimate.uncertain() ? format_uncertain(q.estimate, q.unit) : format_value(q.estimate.value, q.unit, 5));
    if (parameters.headline.empty()) return text;
    const auto& first = parameters.headline.front();
    text += "\n";
    if (first.band)
        text += fmt::format("  waves {} … {}", format_value(2.0 * pi / first.band->lower, "m"),
                            format_value(2.0 * pi / first.band->upper, "m"));
    if (!parameters.levelling.empty()) text += fmt::format("; removed from the heights: {}", parameters.levelling);
    if (first.n) text += fmt::format("; {} measurement{}", *first.n, *first.n == 1 ? "" : "s");
    return text + "\n";
}

std::vector<ParameterEntry> parameter_entries(const Parameters& parameters) {
    std::vector<ParameterEntry> entries;
    for (const auto& group : parameters.groups)
        for (const auto& q : group.quantities) {
            const bool headline = is_to_quote(q);
            entries.push_back({.quantity = q,
                               .file = group.file,
                               .measurement = group.name,
                               .channel = group.channel,
                               .purpose = is_of_lines(q) ? of_lines : group.purpose,
                               .headline = headline,
                               .levelling = headline ? parameters.levelling : std::string()});
        }
    return entries;
}

}  // namespace setae::answers
