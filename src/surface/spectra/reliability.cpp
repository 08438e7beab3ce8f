// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/reliability.hpp"
#include "setae/core/units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "checks.hpp"
#include "second_differences.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::spectra {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// One direction of a measurement: its curvature at a scale, and its scales.
struct Direction {
    CurvatureAtScale curvature;
    double step;
    double size;
};

Direction direction(const CurvatureGrid& grid, double size, const ReliabilityOptions& options,
                    parallel::Threads threads) {
    return {curvature_on_grid(grid, options.percentile, threads), grid.step, size};
}

std::vector<Direction> directions(const HeightMap& map, const ReliabilityOptions& options, parallel::Threads threads) {
    require_shape(map);
    std::vector<Direction> list{
        direction({map.heights, true, map.pixel_size()[0], map.periodic}, map.size[0], options, threads)};
    if (options.both_directions)
        list.push_back(
            direction({map.heights, false, map.pixel_size()[1], map.periodic}, map.size[1], options, threads));
    return list;
}

std::vector<Direction> directions(const LineScan& scan, const ReliabilityOptions& options, parallel::Threads threads) {
    require_shape(scan);
    const Eigen::Map<const Array2D> line(scan.heights.data(), 1, scan.heights.size());
    return {direction({line, false, scan.pixel_size(), scan.periodic}, scan.size, options, threads)};
}

std::vector<Direction> directions(const Profile& profile, const ReliabilityOptions& options, parallel::Threads) {
    topography::validate(profile);
    return {{curvature_of_profile(profile, options.percentile),
             profile.size() / static_cast<double>(profile.positions.size() - 1), profile.size()}};
}

/// Largest scale at which the curvature crosses −1/(2R): found from long stencils down by halving, then bracketed.
TipCutoff cutoff_along(const Direction& direction, double tip_radius) {
    const double threshold = -0.5 / tip_radius, shortest = 2.0 * direction.step, longest = 0.5 * direction.size;
    const auto excess = [&](double length) {
        const double curvature = direction.curvature(length);
        return std::isnan(curvature) ? 1.0 : curvature / -threshold + 1.0;
    };
    TipCutoff result;
    if (longest <= shortest) return {0.0, CutoffStatus::all_reliable, 0.0, {}};
    double above = longest, at_above = excess(above);
    if (at_above < 0.0) return {direction.size, CutoffStatus::nothing_reliable, 0.0, {}};
    for (;;) {
        const double below = std::max(shortest, 0.5 * above), at_below = excess(below);
        if (at_below < 0.0) {
            constexpr int bits = 31;  // 1e-9
            result.value = numerics::bracketed_root(excess, below, above, at_below, at_above, bits);
            return result;
        }
        if (below == shortest) return {0.0, CutoffStatus::all_reliable, 0.0, {}};
        above = below;
        at_above = at_below;
    }
}

TipCutoff worst(const std::vector<Direction>& directions, double tip_radius) {
    TipCutoff result{0.0, CutoffStatus::all_reliable, 0.0, {}};
    for (const auto& direction : directions) {
        const auto candidate = cutoff_along(direction, tip_radius);
        if (candidate.value > result.value) result = candidate;
    }
    return result;
}

struct Sampling {
    double step;
    double size;
};

Sampling sampling(const HeightMap& map) { return {map.pixel_size()[0], map.size[0]}; }
Sampling sampling(const LineScan& scan) { return {scan.pixel_size(), scan.size}; }
Sampling sampling(const Profile& profile) {
    return {profile.size() / static_cast<double>(profile.positions.size() - 1), profile.size()};
}

Alert tip_alert(const topography::Metadata& metadata, double tip_radius, const TipCutoff& tip, const Band& band,
                double nyquist) {
    const std::string action = "use a sharper tip, or another instrument for these wavelengths";
    if (tip.status == CutoffStatus::nothing_reliable)
        return {"TIP_CUTOFF", topography::label(metadata),
                fmt::format("the tip of {} radius is blunter than the surface at all scales, so that no wavelength is "
                            "reliable",
                            format_value(tip_radius, "m", 3)),
                action};
    return {
        "TIP_CUTOFF", topography::label(metadata),
        fmt::format("the tip of {} radius hides wavelengths below {}: the band ends at {} instead of {}, {:.2g} "
                    "decades less",
                    format_value(tip_radius, "m", 3), format_value(tip.value, "m"), format_value(band.upper, "1/m", 3),
                    format_value(nyquist, "1/m", 3), std::log10(nyquist / band.upper)),
        action};
}

void check(const ReliabilityOptions& options) {
    if (!(options.percentile >= 0.0 && options.percentile <= 0.5))
        throw InvalidArgument(fmt::format("percentile {} of the tip criterion; expected 0 … 0.5", options.percentile));
    if (!(options.nyquist_fraction > 0.0 && options.nyquist_fraction <= 1.0))
        throw InvalidArgument(
            fmt::format("Nyquist fraction {}; expected above 0 and at most 1", options.nyquist_fraction));
    if (options.first_mode < 1)
        throw InvalidArgument(fmt::format("first mode {}; expected at least 1", options.first_mode));
}

TipCutoff cutoff_among(const std::vector<Direction>& all, double tip_radius, std::optional<double> standard_error,
                       const ReliabilityOptions& options) {
    check(options);
    if (!(tip_radius > 0.0) || !std::isfinite(tip_radius))
        throw InvalidArgument(fmt::format("tip radius {} m; expected a positive length", tip_radius));
    auto result = worst(all, tip_radius);
    result.percentile = options.percentile;
    if (standard_error) {
        constexpr double two_sided_95 = 1.959963984540054;
        const double reach = two_sided_95 * *standard_error;
        // a radius below a hundredth of the nominal one is unphysical: the normal approximation ends there
        const double sharp = worst(all, std::max(tip_radius - reach, 0.01 * tip_radius)).value;
        result.interval = Interval{sharp, worst(all, tip_radius + reach).value, 0.95};
    }
    return result;
}

template <class Kind>
TipCutoff cutoff_of(const Kind& measurement, double tip_radius, std::optional<double> standard_error,
                    const ReliabilityOptions& options, parallel::Threads threads) {
    return cutoff_among(directions(measurement, options, threads), tip_radius, standard_error, options);
}

/// A map larger than memory and its scan lines that are processed together.
struct TiledLines {
    const topography::TiledMap& map;
    Index lines_together;
    const topography::Metadata& metadata;
};

Sampling sampling(const TiledLines& tiled) { return {tiled.map.pixel_size()[0], tiled.map.size[0]}; }

void keep_worse(TipCutoff& worst, const TipCutoff& other) {
    if (other.interval) {
        if (!worst.interval) worst.interval = other.interval;
        worst.interval->lower = std::max(worst.interval->lower, other.interval->lower);
        worst.interval->upper = std::max(worst.interval->upper, other.interval->upper);
    }
    if (!(other.value > worst.value)) return;
    worst.value = other.value;
    worst.status = other.status;
}

/// The minimum curvature of a map is the minimum over its bands, so its cutoff is that of the worst one.
TipCutoff cutoff_of(const TiledLines& tiled, double tip_radius, std::optional<double> standard_error,
                    const ReliabilityOptions& options, parallel::Threads threads) {
    const auto& map = tiled.map;
    if (options.percentile > 0.0 || options.both_directions)
        throw InvalidArgument(
            fmt::format("{}: a tip criterion with a percentile or along both directions needs the whole map; read the "
                        "map at once, or use the strict minimum along x",
                        topography::label(map.metadata)));
    TipCutoff worst{0.0, CutoffStatus::all_reliable, 0.0, {}};
    for (Index first = 0; first < map.ny; first += tiled.lines_together) {
        const Array2D band = map.lines(first, std::min(tiled.lines_together, map.ny - first));
        keep_worse(
            worst,
            cutoff_among({direction({band, true, map.pixel_size()[0], map.periodic}, map.size[0], options, threads)},
                         tip_radius, standard_error, options));
    }
    return worst;
}

template <class Kind>
ReliableBand band_of(const Kind& measurement, const ReliabilityOptions& options, parallel::Threads threads) {
    check(options);
    const auto [step, size] = sampling(measurement);
    const double nyquist = pi / step;
    ReliableBand result;
    result.band = {2.0 * pi * options.first_mode / size, options.nyquist_fraction * nyquist};
    result.upper_limit = "sampling";
    const auto& instrument = measurement.metadata.instrument;
    const auto limit = [&](double wavelength, const char* cause) {
        if (!(2.0 * pi / wavelength < result.band.upper)) return false;
        result.band.upper = 2.0 * pi / wavelength;
        result.upper_limit = cause;
        return true;
    };
    if (instrument.resolution && *instrument.resolution > 0.0) limit(*instrument.resolution, "resolution");
    if (instrument.tip_radius) {
        result.tip =
            cutoff_of(measurement, *instrument.tip_radius, instrument.tip_radius_standard_error, options, threads);
        if (result.tip->value > 0.0 && limit(result.tip->value, "tip radius"))
            result.alerts.push_back(
                tip_alert(measurement.metadata, *instrument.tip_radius, *result.tip, result.band, nyquist));
    }
    return result;
}

}  // namespace

TipCutoff tip_cutoff(const HeightMap& map, double tip_radius, std::optional<double> tip_radius_standard_error,
                     const ReliabilityOptions& options, parallel::Threads threads) {
    return cutoff_of(map, tip_radius, tip_radius_standard_error, options, threads);
}

TipCutoff tip_cutoff(const LineScan& scan, double tip_radius, std::optional<double> tip_radius_standard_error,
                     const ReliabilityOptions& options, parallel::Threads threads) {
    return cutoff_of(scan, tip_radius, tip_radius_standard_error, options, threads);
}

TipCutoff tip_cutoff(const Profile& profile, double tip_radius, std::optional<double> tip_radius_standard_error,
                     const ReliabilityOptions& options, parallel::Threads threads) {
    return cutoff_of(profile, tip_radius, tip_radius_standard_error, options, threads);
}

TipCutoff tip_cutoff(const topography::Measurement& measurement, double tip_radius,
                     std::optional<double> tip_radius_standard_error, const ReliabilityOptions& options,
                     parallel::Threads threads) {
    return std::visit(
        [&](const auto& m) { return cutoff_of(m, tip_radius, tip_radius_standard_error, options, threads); },
        measurement);
}

ReliableBand reliable_band(const HeightMap& map, const ReliabilityOptions& options, parallel::Threads threads) {
    return band_of(map, options, threads);
}

ReliableBand reliable_band(const LineScan& scan, const ReliabilityOptions& options, parallel::Threads threads) {
    return band_of(scan, options, threads);
}

ReliableBand reliable_band(const Profile& profile, const ReliabilityOptions& options, parallel::Threads threads) {
    return band_of(profile, options, threads);
}

ReliableBand reliable_band(const topography::TiledMap& map, Index lines_together, const ReliabilityOptions& options,
                           parallel::Threads threads) {
    return band_of(TiledLines{map, lines_together, map.metadata}, options, threads);
}

ReliableBand reliable_band(const topography::Measurement& measurement, const ReliabilityOptions& options,
                           parallel::Threads threads) {
    return std::visit([&](const auto& m) { return band_of(m, options, threads); }, measurement);
}

}  // namespace setae::spectra
