// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/processing/fill.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::study {
namespace {

/// Reliable bands a tip one standard error larger and smaller leaves. `band_of` finds that of the data whose
/// `instrument` it is.
template <class BandOf>
std::optional<std::array<Band, 2>> bands_of_uncertain_tip(topography::Instrument& instrument, BandOf band_of) {
    if (!instrument.tip_radius || !instrument.tip_radius_standard_error) return std::nullopt;
    const double radius = *instrument.tip_radius, error = *instrument.tip_radius_standard_error;
    instrument.tip_radius_standard_error.reset();
    const auto band = [&](double moved) -> Band {
        instrument.tip_radius = moved;
        auto reliable = band_of();
        reliable.upper = std::max(reliable.lower, reliable.upper);
        return reliable;
    };
    constexpr double min_share = 1e-3;  // a radius stays positive however large its ±
    return std::array{band(radius + error), band(std::max(radius - error, min_share * radius))};
}

/// Name of a measurement for readers: a container's member has a name of its own, a file is named by itself rather than
/// by its channel.
std::string name_of(const topography::Metadata& metadata) {
    const bool member = metadata.attributes.contains("member");
    return member || metadata.file.empty() ? metadata.name : std::filesystem::path(metadata.file).stem().string();
}

void describe(MeasurementResult& result, const topography::Metadata& metadata, topography::Trend trend,
              const std::vector<Alert>& alerts) {
    result.file = metadata.file;
    result.name = name_of(metadata);
    result.trend = trend;
    result.alerts = alerts;
}

spectra::SpectrumOptions spectrum_options(const SurfaceAnalysisOptions& options, parallel::Threads threads) {
    spectra::SpectrumOptions spectrum;
    spectrum.window = options.window;
    spectrum.contour = options.contours;
    spectrum.reliability.percentile = options.tip_percentile;
    spectrum.threads = threads;
    return spectrum;
}

/// Assumed resolution for an unstated instrument; empty where it is stated.
std::optional<Alert> alert_of_unstated(const topography::Metadata& metadata, bool probe_given, const Band& band) {
    const auto& instrument = metadata.instrument;
    const auto believed = fmt::format("waves are used down to {}", format_value(2.0 * pi / band.upper, "m", 3));
    if (instrument.resolution || instrument.tip_radius || probe_given) return std::nullopt;
    if (instrument.type.empty())
        return Alert{"NO_INSTRUMENT", topography::label(metadata),
                     "neither the file nor the study names the instrument: " + believed,
                     "set instrument = \"afm\" and tip_radius = \"…\" (for an optical instrument: resolution)"};
    if (instrument.type != "afm" && instrument.type != "stylus") return std::nullopt;
    return Alert{"NO_TIP_RADIUS", topography::label(metadata),
                 fmt::format("the tip radius of the {} is not known: {}", instrument.type, believed),
                 "set tip_radius = \"10 ± 3 nm\", for example"};
}

/// A copy whose tip may be changed, where its radius has an error.
std::optional<topography::Measurement> with_uncertain_tip(const topography::Measurement& measurement) {
    const auto& instrument = topography::metadata(measurement).instrument;
    if (!instrument.tip_radius || !instrument.tip_radius_standard_error) return std::nullopt;
    return measurement;
}

/// Whether all of n heights are defined. A sum is NaN where one of them is.
bool all_defined(const double* heights, Index n, parallel::Threads threads) {
    constexpr Index block = 1 << 16;
    std::vector<char> defined(static_cast<std::size_t>((n + block - 1) / block));
    parallel::for_each_index(defined.size(), threads, [&](std::size_t b) {
        const Index first = static_cast<Index>(b) * block;
        const Eigen::Map<const Array1D> part(heights + first, std::min(block, n - first));
        defined[b] = !std::isnan(part.sum()) || !part.isNaN().any() ? 1 : 0;
    });
    return std::all_of(defined.begin(), defined.end(), [](char all) { return all != 0; });
}

/// A copy with its undefined heights filled, where it has some.
std::optional<topography::Measurement> without_gaps(const topography::Measurement& measurement,
                                                    parallel::Threads threads) {
    const auto whole = [threads](const auto& m) { return all_defined(m.heights.data(), m.heights.size(), threads); };
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement); map && !whole(*map))
        return processing::filled(*map, threads);
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement); scan && !whole(*scan))
        return processing::filled(*scan);
    return std::nullopt;
}

/// A map without its trend as pictures show it.
HeightPreview preview_of(const topography::TiledMap& map, Index lines_together) {
    MapPreview preview(map.nx, map.ny, map.size);
    for (Index first = 0; first < map.ny; first += lines_together)
        preview.add(map.lines(first, std::min(lines_together, map.ny - first)), first);
    return preview.result();
}

Alert tiled_map_alert(const topography::Metadata& metadata, const topography::TiledMap& map, std::uint64_t largest) {
    const double gibibyte = std::uint64_t{1} << 30;
    return {"LARGE_MAP", topography::label(metadata),
            fmt::format("the {} × {} heights need {:.2g} GiB, more than the allowed {:.2g} GiB: the map was read by "
                        "bands of scan lines, without slope distribution, triangulated area and arithmetic height",
                        map.nx, map.ny, static_cast<double>(map.nx) * static_cast<double>(map.ny) * 8.0 / gibibyte,
                        static_cast<double>(largest) / gibibyte),
            "to get these results too, allow more memory (`memory`)"};
}

double length_along_x(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return map->size[0];
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement)) return scan->size;
    const auto& positions = std::get<topography::Profile>(measurement).positions;
    return positions.maxCoeff() - positions.minCoeff();
}

/// No instrument distinguishes smaller heights [m].
constexpr double min_height = 1e-15;

/// Heights that are one number, or are numbers in a wrong unit: nothing below looks wrong in a spectrum.
void look_at_heights(MeasurementResult& result, const topography::Metadata& metadata, double extent, bool overhangs) {
    const double steepest = overhangs ? std::numeric_limits<double>::infinity() : 100.0;  // 89.4 degrees
    const auto& real = result.real_space;
    const auto place = topography::label(metadata);
    if (!std::isfinite(real.rms_height) || !std::isfinite(real.rms_slope))
        throw UndefinedDataError(
            fmt::format("{}: the heights are too large for a computation (rms height {:g} m); they are not heights in "
                        "m, or they mark missing heights",
                        place, real.rms_height));
    if (real.rms_height < min_height)
        result.alerts.push_back(
            {"CONSTANT", place,
             fmt::format("the {} heights differ by {:g} m (rms) after levelling, less than any instrument can "
                         "distinguish: they are all equal, or in a wrong unit",
                         real.defined, real.rms_height),
             "leave the file out, or state the unit of its heights"});
    else if (real.rms_slope > steepest || real.rms_height > extent)
        result.alerts.push_back(
            {"HEIGHTS_IMPLAUSIBLE", place,
             fmt::format("rms height {} over {}, rms slope {:.3g}: some values are not heights, or the unit is wrong",
                         format_value(real.rms_height, "m", 3), format_value(extent, "m", 3), real.rms_slope),
             "look at the heights (setae info --preview); mark missing heights, or state the unit"});
}

/// Where points of a polyline are missing, a straight line replaces the surface and lowers slopes.
void look_for_gaps(MeasurementResult& result, const topography::Profile& profile) {
    constexpr double many_steps = 20.0, min_share = 0.02;
    const auto n = profile.positions.size();
    if (n < 3) return;
    const Array1D steps = (profile.positions.tail(n - 1) - profile.positions.head(n - 1)).abs();
    std::vector<double> sorted(steps.begin(), steps.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double usual = *middle, extent = profile.positions.maxCoeff() - profile.positions.minCoeff();
    Index gaps = 0;
    double bridged = 0.0;
    for (const double step : steps)
        if (step > many_steps * usual) {
            ++gaps;
            bridged += step;
        }
    if (!(bridged > min_share * extent)) return;
    result.alerts.push_back(
        {"GAP_BRIDGED", topography::label(profile.metadata),
         fmt::format("{:.0f} % of the length of the profile lie in {} step{} of more than {:g} times the usual {}: "
                     "straight lines replace them, which lowers slopes and curvatures",
                     100.0 * bridged / extent, gaps, gaps == 1 ? "" : "s", many_steps, format_value(usual, "m", 3)),
         "export all points, or list the parts as separate measurements"});
}

}  // namespace

MeasurementResult analyse_measurement(const PreparedMeasurement& prepared, const SurfaceAnalysisOptions& options,
                                      parallel::Threads threads, const Wanted& wanted) {
    const auto& measurement = prepared.measurement;
    MeasurementResult result;
    describe(result, topography::metadata(measurement), prepared.trend, prepared.alerts);
    result.channel = prepared.channel;
    result.inputs = prepared.inputs;
    result.processing = prepared.processing;
    if (wanted.previews) result.preview = height_preview(measurement);
    if (wanted.parameters) {
        result.real_space = roughness::real_space_parameters(measurement, threads);
        look_at_heights(result, topography::metadata(measurement), length_along_x(measurement),
                        std::holds_alternative<topography::Profile>(measurement));
    }
    if (!wanted.spectrum) {
        result.arithmetic_height = undefined;
        return result;
    }
    if (wanted.parameters) {
        result.arithmetic_height = roughness::arithmetic_height(measurement, result.real_space.mean_height, threads);
        if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) {
            result.triangulated = roughness::triangulated_area(*map, threads);
            if (result.triangulated->rms_slope > 0.0)
                result.slope_shape = {roughness::slope_shape(*map, result.triangulated->rms_slope, threads),
                                      map->size[0] * map->size[1]};
        }
    }
    if (const auto* profile = std::get_if<topography::Profile>(&measurement)) look_for_gaps(result, *profile);
    const auto [nx, ny] = topography::shape(measurement);
    if (nx * ny > 64) {
        result.slopes = roughness::slope_distribution(measurement, threads);
        result.alerts.insert(result.alerts.end(), result.slopes->alerts.begin(), result.slopes->alerts.end());
    }
    const auto spectrum = spectrum_options(options, threads);
    const auto whole = without_gaps(measurement, threads);
    result.spectrum = spectra::power_spectrum(whole ? *whole : measurement, spectrum);
    if (const auto* map = std::get_if<topography::HeightMap>(whole ? &*whole : &measurement); map && wanted.parameters)
        result.waves_energy_per_modulus = spectra::energy_per_modulus_of_modes(*map, result.spectrum.band, spectrum);
    if (auto moved = with_uncertain_tip(measurement))
        result.bands_of_uncertain_tip = bands_of_uncertain_tip(topography::metadata(*moved).instrument, [&] {
            return spectra::reliable_band(*moved, spectrum.reliability, threads).band;
        });
    result.alerts.insert(result.alerts.end(), result.spectrum.alerts.begin(), result.spectrum.alerts.end());
    const bool probe_given = prepared.probe.has_value() || prepared.optics.has_value();
    if (auto alert = alert_of_unstated(topography::metadata(measurement), probe_given, result.spectrum.band))
        result.alerts.push_back(std::move(*alert));
    return result;
}

spectra::Spectrum isotropic_spectrum(const topography::HeightMap& map, const SurfaceAnalysisOptions& options,
                                     parallel::Threads threads) {
    return spectra::isotropic_power_spectrum(map, spectrum_options(options, threads));
}

bool too_large(const MeasurementSource& source, const SurfaceAnalysisOptions& options) {
    if (!source.tiled) return false;
    const auto& map = source.tiled->map;
    return static_cast<std::uint64_t>(map.nx) * static_cast<std::uint64_t>(map.ny) * sizeof(double) >
           options.largest_map;
}

MeasurementResult analyse_tiled_map(const TiledMeasurement& large, const SurfaceAnalysisOptions& options,
                                    parallel::Threads threads, const Wanted& wanted) {
    const auto& metadata = large.map.metadata;
    const auto lines_together = topography::lines_in(large.map, static_cast<std::size_t>(options.largest_map));
    MeasurementResult result;
    describe(result, metadata, large.trend, large.alerts);
    if (large.map.alerts)
        for (auto& alert : large.map.alerts()) result.alerts.push_back(std::move(alert));
    result.channel = large.channel;
    result.inputs = large.inputs;
    result.alerts.push_back(tiled_map_alert(metadata, large.map, options.largest_map));
    const auto levelled = topography::detrended(large.map, large.trend, lines_together, threads);
    if (wanted.previews) result.preview = preview_of(levelled, lines_together);
    if (wanted.parameters) result.real_space = roughness::real_space_parameters(levelled, lines_together, threads);
    if (wanted.parameters) look_at_heights(result, metadata, large.map.size[0], false);
    result.arithmetic_height = undefined;
    if (!wanted.spectrum) return result;
    const auto spectrum = spectrum_options(options, threads);
    result.spectrum = spectra::power_spectrum(levelled, lines_together, spectrum);
    auto moved = levelled;
    result.bands_of_uncertain_tip = bands_of_uncertain_tip(moved.metadata.instrument, [&] {
        return spectra::reliable_band(moved, lines_together, spectrum.reliability, threads).band;
    });
    result.alerts.insert(result.alerts.end(), result.spectrum.alerts.begin(), result.spectrum.alerts.end());
    if (auto alert = alert_of_unstated(metadata, false, result.spectrum.band))
        result.alerts.push_back(std::move(*alert));
    return result;
}

}  // namespace setae::study
