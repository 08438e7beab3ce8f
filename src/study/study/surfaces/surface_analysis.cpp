// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/surface_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "average_spectrum.hpp"
#include "given_spectrum.hpp"
#include "likelihood_spectrum.hpp"
#include "measured_slopes.hpp"
#include "results/same_measurements.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "surface_run.hpp"

namespace setae::study {
namespace {

using roughness::SpectralParameters;
using spectra::Spectrum;

struct Task {
    std::string file;
    ResultKey key;  ///< key of its result
    MeasurementSource source;
};

std::vector<Task> tasks_of(const SurfaceInput& input, const SurfaceAnalysisOptions& options, const Run& run,
                           const Wanted& wanted) {
    std::vector<Task> tasks;
    for (const auto& measurement : input.measurements) {
        try {
            std::size_t ordinal = 0;
            for (auto& source : measurement_sources(measurement))
                tasks.push_back(
                    {measurement.file, measurement_key(run, measurement, ordinal++, options), std::move(source)});
        } catch (const std::exception& error) {
            if (wanted.every_measurement) throw;
            tasks.push_back(
                {measurement.file,
                 {},
                 {[message = reason_of(error, measurement.file)]() -> PreparedMeasurement { throw FileError(message); },
                  {}}});
        }
    }
    return tasks;
}

/// @throws UndefinedDataError for heights that are one number: they would lower the roughness of the others.
void require_roughness(const MeasurementResult& result) {
    for (const auto& alert : result.alerts)
        if (alert.code == "CONSTANT") throw UndefinedDataError(alert.subject + ": " + alert.message);
}

/// Fills the measurements of a surface. Returns their prepared data where a joint estimate follows or heights are
/// requested, in the same order, else nothing: for an average, maps need not all fit into memory at once.
std::vector<PreparedMeasurement> analyse_measurements(SurfaceResult& surface, const SurfaceInput& input,
                                                      const SurfaceAnalysisOptions& options, Run& run,
                                                      parallel::Threads threads, const Wanted& wanted) {
    const auto tasks = tasks_of(input, options, run, wanted);
    run.expect(tasks.size() - std::min(tasks.size(), input.measurements.size()), measurement_work);
    const bool joint = wanted.spectrum && wants_likelihood(options, std::ssize(tasks)),
               keep = joint || (wanted.map && tasks.size() == 1);
    std::vector<PreparedMeasurement> kept(keep ? tasks.size() : 0);
    surface.measurements.resize(tasks.size());
    const parallel::Threads inside = tasks.size() == 1 ? threads : parallel::Threads{1};
    parallel::for_each_index(tasks.size(), threads, [&](std::size_t i) {
        if (run.cancelled()) return;
        const auto& task = tasks[i];
        run.step_begins("measurement", task.file);
        auto& result = surface.measurements[i];
        auto found = run.find<MeasurementResult>(task.key);
        try {
            PreparedMeasurement prepared;
            const bool large = !joint && too_large(task.source, options);
            if (!large && (keep || !found)) prepared = task.source.prepare();
            if (found) result = std::move(*found);
            else
                result = large ? analyse_tiled_map(*task.source.tiled, options, inside, wanted)
                               : analyse_measurement(prepared, options, inside, wanted);
            if (!wanted.every_measurement) require_roughness(result);
            if (!found) run.keep(task.key, result);
            if (keep) kept[i] = std::move(prepared);
        } catch (const std::exception& error) {
            if (wanted.every_measurement) throw;
            result.error = reason_of(error, task.file);
        }
        result.file = task.file;
        run.step_done("measurement", task.file, found.has_value(), measurement_work);
    });
    run.stop_if_cancelled();
    return kept;
}

std::optional<topography::HeightMap> only_map(std::vector<PreparedMeasurement> prepared) {
    if (prepared.size() != 1) return std::nullopt;
    auto* map = std::get_if<topography::HeightMap>(&prepared.front().measurement);
    return map && map->heights.size() > 0 ? std::optional(std::move(*map)) : std::nullopt;
}

/// The likelihood's spectrum in addition to the average, where it is requested and possible.
void add_likelihood(SurfaceResult& surface, std::vector<PreparedMeasurement> prepared,
                    const SurfaceAnalysisOptions& options, parallel::Threads threads) {
    const auto analysed = std::count_if(surface.measurements.begin(), surface.measurements.end(),
                                        [](const auto& m) { return !m.failed(); });
    if (!wants_likelihood(options, analysed)) return;
    try {
        estimate_by_likelihood(surface, std::move(prepared), options, threads);
    } catch (const std::exception& error) {
        surface.likelihood_error = reason_of(error);
        surface.alerts.push_back({"LIKELIHOOD_FAILED", surface.name, surface.likelihood_error,
                                  "use the results with care: they are those of the average over measurements"});
    }
}

/// Files that failed, and whether the spectrum is another for it.
void add_failure_alert(SurfaceResult& surface, const SurfaceAnalysisOptions& options) {
    std::string files;
    std::ptrdiff_t failed = 0;
    for (const auto& measurement : surface.measurements) {
        if (!measurement.failed()) continue;
        ++failed;
        files += (files.empty() ? "" : ", ") + measurement.file;
    }
    if (failed == 0) return;
    const auto all = std::ssize(surface.measurements);
    const bool changed = wants_likelihood(options, all) && !wants_likelihood(options, all - failed);
    surface.alerts.push_back({"FILES_LEFT_OUT", surface.name,
                              fmt::format("{} of {} measurements failed and are left out ({}){}", failed, all, files,
                                          changed ? "; the average of the remaining one replaces the likelihood" : ""),
                              "repair the files, or remove them from the study"});
}

/// "12 % (10 to 14)" or "a factor of 2.5 (1.9 to 3.4)": a parameter with waves that are not measured over that of the
/// band.
std::string more(const Estimate& with, double within) {
    const double lower = with.interval->lower / within, value = with.value / within,
                 upper = with.interval->upper / within;
    if (value >= 2.0) return fmt::format("a factor of {:.2g} ({:.2g} to {:.2g})", value, lower, upper);
    return fmt::format("{:.2g} % ({:.2g} to {:.2g})", 100.0 * (value - 1.0), 100.0 * (lower - 1.0),
                       100.0 * (upper - 1.0));
}

/// @throws UndefinedDataError where every measurement failed.
void require_measurements(const SurfaceResult& surface) {
    if (std::all_of(surface.measurements.begin(), surface.measurements.end(),
                    [](const auto& measurement) { return measurement.failed(); }))
        throw UndefinedDataError("no measurement was analysed");
}

/// The spectrum extrapolated to a wavevector; empty where too few nodes determine its end.
std::optional<roughness::BeyondData> continued(const spectra::Spectrum& curve, double up_to) {
    try {
        return roughness::beyond_data(curve, up_to);
    } catch (const UndefinedDataError&) {
        return std::nullopt;
    }
}

/// Contributions of waves shorter than the finest data, and a warning where they are large.
void look_beyond_data(SurfaceResult& surface, const SurfaceAnalysisOptions& options) {
    constexpr double nearly_whole = 0.9, much = 0.05;
    const auto& curve = surface.used().curve;
    const double end =
        2.0 * pi / std::max(options.limits().shortest.value_or(0.0), options.likelihood.shortest_wavelength);
    if (curve.band.upper > nearly_whole * end) return;
    surface.beyond_data = continued(curve, end);
    if (!surface.beyond_data) return;
    const auto& beyond = *surface.beyond_data;
    const auto& parameters = surface.used().parameters;
    const double area = roughness::gaussian_area_ratio(parameters.rms_slope) - 1.0;
    if (!(beyond.excess_area.value > (1.0 + much) * area)) return;
    surface.alerts.push_back(
        {"WAVES_BEYOND_DATA", surface.name,
         fmt::format("the results do not contain waves from {:.3g} to {:.3g} nm; if C_iso continues as q^{:.2f}, "
                     "these waves raise the rms slope by {}, A_true/A_app − 1 by {} and U_el by {}",
                     2e9 * pi / beyond.end, 2e9 * pi / beyond.up_to, beyond.exponent.value,
                     more(beyond.rms_slope, parameters.rms_slope), more(beyond.excess_area, area),
                     more(beyond.elastic_energy_per_modulus, parameters.elastic_energy_per_modulus)),
         "measure at smaller scales, or give the wavelength at which the waves of the surface end "
         "(surface_shortest_wavelength)"});
}

/// Contributions of waves up to ten times as long as the longest, and a warning where they are large. A requested
/// longest wavelength excludes longer ones on purpose.
void look_at_longer_waves(SurfaceResult& surface, const SurfaceAnalysisOptions& options) {
    constexpr double much = 0.05, times = 10.0;
    if (options.longest_wavelength) return;
    const auto& curve = surface.used().curve;
    surface.longer_waves = continued(curve, curve.band.lower / times);
    if (!surface.longer_waves) return;
    const auto& longer = *surface.longer_waves;
    const auto& parameters = surface.used().parameters;
    const double height = longer.rms_height.value / parameters.rms_height,
                 energy = longer.elastic_energy_per_modulus.value / parameters.elastic_energy_per_modulus;
    if (!(std::max(height, energy) > 1.0 + much)) return;
    surface.alerts.push_back(
        {"BAND_LIMITED", surface.name,
         fmt::format("the results do not contain waves longer than {}; if the spectrum continues as in its first "
                     "decade, waves up to {} raise h_rms by {} and U_el by {}",
                     format_value(2.0 * pi / longer.end, "m"), format_value(2.0 * pi / longer.up_to, "m"),
                     more(longer.rms_height, parameters.rms_height),
                     more(longer.elastic_energy_per_modulus, parameters.elastic_energy_per_modulus)),
         "measure a larger area of the surface, for instance with a stylus; if these waves are longer "
         "than the contact, set longest_wavelength"});
}

/// The stored energy is of first order in slopes, the area is not.
void look_at_slopes(SurfaceResult& surface) {
    constexpr double steep = 0.5;
    const double slope = surface.used().parameters.rms_slope;
    if (!(slope > steep)) return;
    surface.alerts.push_back(
        {"STEEP_SLOPES", surface.name,
         fmt::format("the rms slope of {:.2g} is above {}: the stored energy U_el ([D19] Eq. 8) assumes small slopes "
                     "and is approximate; A_true/A_app holds for any slope",
                     slope, steep),
         "use U_el, and works of adhesion that contain it, as estimates"});
}

/// One reading has no scatter between places.
void look_for_one_place(SurfaceResult& surface) {
    const auto analysed = std::count_if(surface.measurements.begin(), surface.measurements.end(),
                                        [](const auto& m) { return !m.failed(); });
    if (analysed != 1) return;
    surface.alerts.push_back(
        {"ONE_PLACE", surface.name,
         "one measurement shows no variation between places: its ± holds for other places only if the "
         "surface is the same everywhere",
         "measure three places or more"});
}

/// Identity of measurements: the content of their files, or their positions where that is unknown, and the channels.
std::vector<std::string> contents_of(const SurfaceInput& input, const Run& run) {
    std::vector<std::string> contents;
    for (const auto& measurement : input.measurements) {
        const auto digest = run.digest(measurement.file);
        contents.push_back(
            (digest.empty() ? std::filesystem::path(measurement.file).lexically_normal().string() : digest) + "\n" +
            measurement.channel.value_or(""));
    }
    return contents;
}

/// @throws UndefinedDataError for a surface whose spectrum gives no numbers within the requested limits.
void require_numbers(const SurfaceResult& surface) {
    for (const auto& [method, spectrum] : spectra_of(surface)) {
        const auto& p = spectrum->parameters;
        if (std::isfinite(p.rms_height) && std::isfinite(p.rms_slope) && std::isfinite(p.elastic_energy_per_modulus))
            continue;
        const auto& band = spectrum->curve.band;
        throw UndefinedDataError(fmt::format(
            "the spectrum ({}) gives no rms height, slope and energy: only waves from {} to {} are left; "
            "increase longest_wavelength or reduce shortest_wavelength",
            method, format_value(2.0 * pi / band.upper, "m", 3), format_value(2.0 * pi / band.lower, "m", 3)));
    }
}

}  // namespace

SurfaceWithMap analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options, Run& run,
                               parallel::Threads threads, const Wanted& wanted) {
    const double work = surface_work(options, input.measurements.size());
    const auto key = input.measurements.empty() ? ResultKey() : surface_key(run, input, options);
    if (auto found = run.find<SurfaceResult>(key)) {
        run.expect(found->measurements.size() - std::min(found->measurements.size(), input.measurements.size()),
                   measurement_work);
        for (const auto& measurement : found->measurements)
            run.step_done("measurement", measurement.file, true, measurement_work);
        run.step_done("surface", input.name, true, work);
        return {std::move(*found), {}};
    }
    SurfaceResult surface;
    std::optional<topography::HeightMap> heights;
    surface.name = input.name;
    try {
        if (input.moments) {
            take_moments(surface, *input.moments, options);
        } else if (input.power_spectrum) {
            take_power_spectrum(surface, input, options);
            look_beyond_data(surface, options);
            look_at_longer_waves(surface, options);
        } else {
            auto prepared = analyse_measurements(surface, input, options, run, threads, wanted);
            if (!wanted.spectrum) {
                require_measurements(surface);
                return {std::move(surface), {}};
            }
            run.step_begins("surface", input.name);
            estimate_by_average(surface, options, threads);
            add_failure_alert(surface, options);
            look_for_copies(surface, contents_of(input, run));
            if (wanted.map && prepared.size() == 1) heights = only_map(std::move(prepared));
            else add_likelihood(surface, std::move(prepared), options, threads);
            use_measured_slopes(surface);
            look_beyond_data(surface, options);
            look_at_longer_waves(surface, options);
            look_for_one_place(surface);
        }
        require_numbers(surface);
        look_at_slopes(surface);
        // a failure may be gone the next time
        if (std::none_of(surface.measurements.begin(), surface.measurements.end(),
                         [](const auto& m) { return m.failed(); }))
            run.keep(key, surface);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        if (wanted.every_measurement) throw;
        surface.error = reason_of(error);
    }
    run.step_done("surface", input.name, false, work);
    return {std::move(surface), std::move(heights)};
}

SurfaceResult analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options,
                              parallel::Threads threads) {
    return analyse_surface(input, options, Wanted{}, threads).surface;
}

SurfaceWithMap analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options, const Wanted& wanted,
                               parallel::Threads threads) {
    Run run;
    return analyse_surface(input, options, run, threads, wanted);
}

std::vector<PlannedStep> planned_steps(const SurfaceInput& input, const SurfaceAnalysisOptions& options,
                                       const Run& run) {
    const bool whole = !input.measurements.empty() && run.holds(surface_key(run, input, options));
    std::vector<PlannedStep> steps;
    for (const auto& measurement : input.measurements) {
        try {
            for (std::size_t ordinal = 0; ordinal < measurement_sources(measurement).size(); ++ordinal)
                steps.push_back({"measurement",
                                 measurement.file,
                                 {},
                                 whole || run.holds(measurement_key(run, measurement, ordinal, options))});
        } catch (const std::exception& error) {
            steps.push_back({"measurement", measurement.file, reason_of(error, measurement.file), false});
        }
    }
    PlannedStep last{"surface", input.name, {}, whole};
    try {
        if (input.power_spectrum) (void)tables::read_power_spectrum_table(*input.power_spectrum, input.spectrum_units);
    } catch (const std::exception& error) {
        last.error = reason_of(error, *input.power_spectrum);
    }
    steps.push_back(std::move(last));
    return steps;
}

roughness::WavelengthLimits SurfaceAnalysisOptions::limits() const {
    const auto value = [](const std::optional<Estimate>& limit) {
        return limit ? std::optional(limit->value) : std::nullopt;
    };
    return {value(longest_wavelength), value(shortest_wavelength)};
}

SpectralParameters parameters_of(Spectrum whole, const SurfaceAnalysisOptions& options) {
    whole.waves_end = 2.0 * pi / options.likelihood.shortest_wavelength;
    return roughness::spectral_parameters(roughness::limited(std::move(whole), options.limits()), options.conversion);
}

namespace {

/// Effect of the standard error of a limit of integrals, where the spectrum extends that far: parameters with it one
/// standard error longer and shorter.
void add_limit_source(roughness::ParameterSpread& spread, const char* name,
                      std::optional<Estimate> SurfaceAnalysisOptions::*limit, const Spectrum& whole,
                      const SurfaceAnalysisOptions& options) {
    const auto& stated = options.*limit;
    if (!stated || !stated->uncertain()) return;
    const auto moved = [&](double side) {
        auto other = options;
        (other.*limit)->value += side * stated->standard_error;
        return other;
    };
    const auto longer = moved(1.0), shorter = moved(-1.0);
    const Band with_longer = roughness::limited(whole, longer.limits()).band,
               with_shorter = roughness::limited(whole, shorter.limits()).band;
    if (with_longer.lower == with_shorter.lower && with_longer.upper == with_shorter.upper) return;
    spread.sources.push_back({stated->input.empty() ? std::string(name) : stated->input, parameters_of(whole, longer),
                              parameters_of(whole, shorter)});
}

}  // namespace

SpectrumResult spectrum_result(Spectrum whole, const SurfaceAnalysisOptions& options) {
    whole.waves_end = 2.0 * pi / options.likelihood.shortest_wavelength;
    SpectrumResult result;
    const bool cut = options.longest_wavelength || options.shortest_wavelength;
    result.curve = roughness::limited(whole, options.limits());
    result.parameters = roughness::spectral_parameters(result.curve, options.conversion);
    result.uncut_energy_per_modulus =
        (cut ? roughness::spectral_parameters(whole, options.conversion) : result.parameters)
            .elastic_energy_per_modulus;
    if (result.curve.kind == spectra::Density::C1D) {
        const bool exact = options.conversion == roughness::Conversion::exact;
        result.other_conversion = roughness::spectral_parameters(
            result.curve, exact ? roughness::Conversion::eq11 : roughness::Conversion::exact);
    }
    add_limit_source(result.spread, "longest wavelength", &SurfaceAnalysisOptions::longest_wavelength, whole, options);
    add_limit_source(result.spread, "shortest wavelength", &SurfaceAnalysisOptions::shortest_wavelength, whole,
                     options);
    return result;
}

std::string method_name(const SurfaceResult& surface, SpectrumMethod method) {
    if (surface.reconstructed) return "moments";
    if (surface.measurements.empty()) return "given";
    return method == SpectrumMethod::average ? "average" : "likelihood";
}

std::vector<NamedSpectrum> spectra_of(const SurfaceResult& surface) {
    std::vector<NamedSpectrum> found{{method_name(surface, SpectrumMethod::average), &surface.average}};
    if (!surface.likelihood) return found;
    const NamedSpectrum likelihood{method_name(surface, SpectrumMethod::likelihood), &*surface.likelihood};
    found.insert(surface.method == SpectrumMethod::likelihood ? found.begin() : found.end(), likelihood);
    return found;
}

SpectralParameters parameters_within(const SpectrumResult& spectrum, const roughness::WavelengthLimits& limits,
                                     roughness::Conversion conversion) {
    auto parameters = roughness::spectral_parameters(roughness::limited(spectrum.curve, limits), conversion);
    parameters.area_shape = spectrum.parameters.area_shape;
    return parameters;
}

}  // namespace setae::study
