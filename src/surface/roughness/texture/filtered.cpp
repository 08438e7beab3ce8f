// SPDX-License-Identifier: GPL-3.0-or-later
#include "filtered.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/processing/iso_filter.hpp"
#include "setae/spectra/reliability.hpp"

namespace setae::texture {
namespace {

void require_filters(const MeasurementView& measurement, const Filters& filters, ProfileKind kind) {
    const auto name = topography::label(measurement.metadata());
    for (const auto& nesting : {filters.s_filter, filters.l_filter})
        if (nesting && !(*nesting > 0.0))
            throw InvalidArgument(fmt::format("{}: nesting index of a filter is {} m; expected > 0", name, *nesting));
    if (filters.s_filter && filters.l_filter && !(*filters.s_filter < *filters.l_filter))
        throw InvalidArgument(fmt::format("{}: the S-filter of {} leaves nothing below the L-filter of {}", name,
                                          format_value(*filters.s_filter, "m"), format_value(*filters.l_filter, "m")));
    if (kind == ProfileKind::waviness && !filters.l_filter)
        throw InvalidArgument(name + ": waviness needs an L-filter, and none is given; give one");
    if ((filters.s_filter || filters.l_filter) && measurement.as<topography::Profile>())
        throw InvalidArgument(
            name +
            ": filters need equal steps, and this is a polyline; resample it, or compute parameters without "
            "filters");
}

/// A length without superfluous digits.
std::string length(double value) {
    const auto text = format_value(value, "m", 6);
    const auto blank = text.find(' ');
    auto number = text.substr(0, blank);
    if (number.find('.') != std::string::npos) {
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.') number.pop_back();
    }
    return number + text.substr(blank);
}

}  // namespace

std::optional<topography::Measurement> filtered(const MeasurementView& measurement, const Filters& filters,
                                                ProfileKind kind, parallel::Threads threads) {
    require_filters(measurement, filters, kind);
    const bool with_l = filters.l_filter && kind != ProfileKind::primary;
    if (!filters.s_filter && !with_l) return {};
    auto result = measurement.visit([](const auto& m) { return topography::Measurement(m); });
    const auto pass = [&](double cutoff, processing::Kept keep) {
        result = processing::apply(processing::GaussianFilter{.cutoff = cutoff, .keep = keep, .order = 1},
                                   std::move(result), threads)
                     .measurement;
    };
    if (filters.s_filter) pass(*filters.s_filter, processing::Kept::long_waves);
    if (with_l)
        pass(*filters.l_filter,
             kind == ProfileKind::waviness ? processing::Kept::long_waves : processing::Kept::short_waves);
    return result;
}

std::string description(const Filters& filters, ProfileKind kind) {
    std::string text;
    if (filters.s_filter) text = "Gaussian S-filter " + length(*filters.s_filter);
    if (filters.l_filter && kind != ProfileKind::primary)
        text += (text.empty() ? "" : ", ") +
                std::string(kind == ProfileKind::waviness ? "waves longer than the Gaussian L-filter "
                                                          : "Gaussian L-filter ") +
                length(*filters.l_filter);
    return text.empty() ? "none" : text;
}

Bandwidth bandwidth(const MeasurementView& measurement, const Filters& filters, ProfileKind kind,
                    parallel::Threads threads) {
    const auto reliable =
        measurement.visit([threads](const auto& m) { return spectra::reliable_band(m, {}, threads); });
    Bandwidth result{reliable.band, reliable.alerts};
    if (filters.s_filter) result.band.upper = std::min(result.band.upper, 2.0 * pi / *filters.s_filter);
    if (filters.l_filter && kind == ProfileKind::roughness)
        result.band.lower = std::max(result.band.lower, 2.0 * pi / *filters.l_filter);
    if (filters.l_filter && kind == ProfileKind::waviness)
        result.band.upper = std::min(result.band.upper, 2.0 * pi / *filters.l_filter);
    return result;
}

std::vector<Alert> undefined_alerts(const MeasurementView& measurement) {
    const auto [undefined_heights, all] = measurement.visit([](const auto& m) {
        return std::pair{m.heights.isNaN().count(), m.heights.size()};
    });
    const double share = static_cast<double>(undefined_heights) / static_cast<double>(all);
    if (share <= 0.01) return {};
    return {{"UNDEF", topography::label(measurement.metadata()),
             fmt::format("{:.1f} % of the heights are undefined", 100.0 * share),
             "fill the undefined heights or crop the measurement; the parameters are those of the defined "
             "heights"}};
}

bool depends_on_short_waves(std::string_view symbol) {
    static constexpr std::array symbols{"Sdq", "Sdr", "Sdq_c", "Sdr_c", "Spc", "Svc", "Rdq", "Rda", "Rdq_2"};
    return std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

}  // namespace setae::texture
