// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/surface_analysis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/channel.hpp"
#include "setae/io/format.hpp"
#include "setae/io/power_spectrum_table.hpp"
#include "setae/spectra/bootstrap.hpp"
#include "setae/synthesis/self_affine.hpp"
#include "setae/topography/artefact.hpp"
#include "setae/topography/contour.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::workflow {
namespace {

using roughness::SpectralParameters;
using roughness::SpectrumCurve;

/// What an instrument's data are levelled by where nobody says otherwise ([D19]: stylus parabola, AFM and TEM tilt).
topography::Trend usual_trend(const std::string& instrument) {
    return instrument == "stylus" ? topography::Trend::parabola : topography::Trend::tilt;
}

void apply_instrument(topography::Instrument& instrument, const MeasurementInput& input) {
    if (!input.instrument.empty()) instrument.type = input.instrument;
    if (input.resolution) instrument.resolution = input.resolution;
    if (!input.tip_radius) return;
    instrument.tip_radius = input.tip_radius->value;
    if (input.tip_radius->standard_error > 0.0) instrument.tip_radius_standard_error = input.tip_radius->standard_error;
}

topography::LineScan subtract_references(const topography::LineScan& scan, const MeasurementInput& input, const io::ReadOptions& options) {
    std::vector<topography::LineScan> references;
    for (const auto& file : input.references) {
        const auto measurement = io::read(file, 0, options);
        const auto* reference = std::get_if<topography::LineScan>(&measurement);
        if (!reference) throw InvalidArgument(fmt::format("{}: a reference of a line scan must be a line scan with equal steps", file));
        references.push_back(*reference);
    }
    return topography::subtract_artefact(scan, topography::average_reference(references));
}

/// Lines with undefined points become polylines through the others; contours become functions of x.
void make_analysable(PreparedMeasurement& prepared) {
    auto& measurement = prepared.measurement;
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement); scan && scan->heights.isNaN().any()) {
        const auto missing = scan->heights.isNaN().count();
        prepared.alerts.push_back({"UNDEFINED", scan->metadata.file,
                                   fmt::format("{} of {} heights are undefined; the line is taken as a polyline through the others", missing, scan->heights.size()),
                                   "measure again if the gaps are wide"});
        measurement = topography::to_profile(*scan);
    }
    if (const auto* profile = std::get_if<topography::Profile>(&measurement)) {
        auto cleaned = topography::clean_contour(*profile);
        prepared.alerts.insert(prepared.alerts.end(), cleaned.alerts.begin(), cleaned.alerts.end());
        measurement = std::move(cleaned.profile);
    }
}

PreparedMeasurement prepare(const io::Channel& channel, const MeasurementInput& input, const io::ReadOptions& options) {
    PreparedMeasurement prepared;
    prepared.alerts = channel.info.alerts;
    prepared.measurement = channel.read();
    apply_instrument(topography::metadata(prepared.measurement).instrument, input);
    if (!input.references.empty()) {
        const auto* scan = std::get_if<topography::LineScan>(&prepared.measurement);
        if (!scan) throw InvalidArgument(fmt::format("{}: references are subtracted from line scans with equal steps only", input.file));
        prepared.measurement = subtract_references(*scan, input, options);
    }
    make_analysable(prepared);
    const auto& instrument = topography::metadata(prepared.measurement).instrument.type;
    prepared.trend = input.trend.value_or(channel.info.recommended_trend.value_or(usual_trend(instrument)));
    prepared.measurement = topography::detrended(std::move(prepared.measurement), prepared.trend);
    topography::validate(prepared.measurement);
    return prepared;
}

SpectrumCurve curve_of(const spectra::CombinedSpectrum& combined) {
    return {combined.wavevector, combined.C1D, {combined.q_min, combined.q_max}};
}

/// A single measurement speaks with its own modes: no bins, so sums over them obey Parseval. The first mode stands for
/// half a step on either side.
SpectrumCurve curve_of(const spectra::PowerSpectrum1D& spectrum) {
    const auto own = spectra::within_band(spectrum);
    const double half_step = 0.5 * (own.wavevector.size() > 1 ? own.wavevector[1] - own.wavevector[0] : own.wavevector[0]);
    return {own.wavevector, own.C1D, {own.wavevector[0] - half_step, own.q_max}, roughness::Density::C1D, roughness::Nodes::modes};
}

SpectralParameters evaluate(const SpectrumCurve& curve, const AnalysisOptions& options) {
    return roughness::spectral_parameters(roughness::limited(curve, options.limits), options.conversion);
}

std::vector<spectra::PowerSpectrum1D> spectra_of(const std::vector<MeasurementResult>& measurements) {
    std::vector<spectra::PowerSpectrum1D> found;
    for (const auto& m : measurements)
        if (!m.failed()) found.push_back(m.spectrum);
    return found;
}

spectra::ReliabilityOptions reliability(const AnalysisOptions& options) {
    spectra::ReliabilityOptions reliability;
    reliability.percentile = options.tip_percentile;
    return reliability;
}

/// Reliable bands a tip one standard error larger and smaller leaves.
std::optional<std::array<Band, 2>> bands_of_uncertain_tip(topography::Measurement measurement, const spectra::ReliabilityOptions& options, parallel::Threads threads) {
    auto& instrument = topography::metadata(measurement).instrument;
    if (!instrument.tip_radius || !instrument.tip_radius_standard_error) return std::nullopt;
    const double radius = *instrument.tip_radius, error = *instrument.tip_radius_standard_error;
    instrument.tip_radius_standard_error.reset();
    const auto band = [&](double moved) {
        instrument.tip_radius = moved;
        auto reliable = spectra::reliable_band(measurement, options, threads).band;
        reliable.upper = std::max(reliable.lower, reliable.upper);
        return reliable;
    };
    constexpr double least_share = 1e-3;  // a radius stays positive however large its ±
    return std::array{band(radius + error), band(std::max(radius - error, least_share * radius))};
}

/// Spectra as all uncertain tips moved together would leave them: radii are shared by the measurements of an instrument,
/// so their errors do not average out.
std::vector<spectra::PowerSpectrum1D> with_moved_tips(const std::vector<MeasurementResult>& measurements, std::size_t direction) {
    std::vector<spectra::PowerSpectrum1D> moved;
    for (const auto& m : measurements) {
        if (m.failed()) continue;
        moved.push_back(m.spectrum);
        if (!m.bands_of_uncertain_tip) continue;
        moved.back().q_min = (*m.bands_of_uncertain_tip)[direction].lower;
        moved.back().q_max = (*m.bands_of_uncertain_tip)[direction].upper;
    }
    return moved;
}

bool has_uncertain_tip(const std::vector<MeasurementResult>& measurements) {
    return std::any_of(measurements.begin(), measurements.end(), [](const MeasurementResult& m) { return m.bands_of_uncertain_tip.has_value(); });
}

void add_bootstrap(SurfaceResult& surface, const spectra::BinnedSpectra& binned, const AnalysisOptions& options, parallel::Threads threads) {
    if (options.bootstrap_resamples == 0 || binned.C1D.rows() < 2) return;
    spectra::BootstrapOptions bootstrap;
    bootstrap.resamples = options.bootstrap_resamples;
    bootstrap.seed = options.seed;
    bootstrap.weighting = options.weighting;
    bootstrap.threads = threads;
    const auto resampled = spectra::bootstrap(binned, bootstrap);
    const auto full = curve_of(*surface.combined);
    for (Index i = 0; i < resampled.C1D.rows(); ++i)
        surface.spread.replicas.push_back(evaluate({resampled.wavevector, resampled.C1D.row(i), full.band}, options));
}

void analyse_combined(SurfaceResult& surface, const AnalysisOptions& options, parallel::Threads threads) {
    const auto found = spectra_of(surface.measurements);
    if (found.empty()) throw UndefinedDataError(fmt::format("none of its {} measurements could be analysed", surface.measurements.size()));
    spectra::CombinationOptions combination;
    combination.weighting = options.weighting;
    const auto binned = spectra::binned(found, combination);
    surface.combined = spectra::combine(found, combination);
    surface.curve = found.size() == 1 ? curve_of(found.front()) : curve_of(*surface.combined);
    surface.alerts.insert(surface.alerts.end(), surface.combined->alerts.begin(), surface.combined->alerts.end());
    add_bootstrap(surface, binned, options, threads);
    if (!has_uncertain_tip(surface.measurements)) return;
    const auto moved = [&](std::size_t direction) {
        const auto spectra = with_moved_tips(surface.measurements, direction);
        return evaluate(spectra.size() == 1 ? curve_of(spectra.front()) : curve_of(spectra::combine(spectra, combination)), options);
    };
    surface.spread.sources.push_back({"tip radius", moved(0), moved(1)});
}

/// C_iso of a self-affine model as a curve from wavelengths of 1 cm on (what lies beyond adds 1e-7 of h_rms² or less).
/// It is one power law on either side of the roll-off, so nodes there and at the ends hold it; more show it scale by scale.
SpectrumCurve curve_of(const synthesis::SelfAffine& model) {
    constexpr Index nodes = 100;  // on each side of the roll-off
    const double lower = 2.0 * pi / 1e-2;
    const auto spaced = [](double from, double to) -> Array1D { return (Array1D::LinSpaced(nodes, std::log(from), std::log(to))).exp(); };
    Array1D q(2 * nodes - 1);
    q << spaced(lower, model.rolloff_wavevector), spaced(model.rolloff_wavevector, model.short_wavevector).tail(nodes - 1);
    q[nodes - 1] = model.rolloff_wavevector;
    q[2 * nodes - 2] = model.short_wavevector;
    return {q, synthesis::isotropic_power_spectrum(model, q), {lower, model.short_wavevector}, roughness::Density::C_iso};
}

void analyse_moments(SurfaceResult& surface, const PublishedMoments& moments, const AnalysisOptions& options) {
    const double height = moments.rms_height.value, slope = moments.rms_slope.value, curvature = moments.rms_curvature.value;
    const auto reconstruct = [&](double h, double s, double c) { return curve_of(synthesis::self_affine_with_moments(h, s, c, moments.short_wavevector)); };
    surface.reconstructed = true;
    surface.curve = reconstruct(height, slope, curvature);
    const auto source = [&](const char* name, double dh, double ds, double dc) {
        if (dh == 0.0 && ds == 0.0 && dc == 0.0) return;
        try {
            surface.spread.sources.push_back({name, evaluate(reconstruct(height + dh, slope + ds, curvature + dc), options),
                                              evaluate(reconstruct(height - dh, slope - ds, curvature - dc), options)});
        } catch (const InvalidArgument& error) {
            surface.alerts.push_back({"SPREAD_INCOMPLETE", surface.name, fmt::format("the ± of its {} leads outside self-affine spectra: {}", name, error.what()),
                                      "the standard errors leave it out"});
        }
    };
    source("rms height", moments.rms_height.standard_error, 0.0, 0.0);
    source("rms slope", 0.0, moments.rms_slope.standard_error, 0.0);
    source("rms curvature", 0.0, 0.0, moments.rms_curvature.standard_error);
    surface.alerts.push_back({"RECONSTRUCTION", surface.name,
                              fmt::format("its spectrum is a self-affine reconstruction from three published moments with short cutoff {:.4g} 1/m", moments.short_wavevector),
                              "it fixes rms height, slope and curvature; the stored energy in between is the model's"});
}

void analyse_power_spectrum(SurfaceResult& surface, const std::string& file) {
    const auto table = io::read_power_spectrum_table(file);
    surface.curve = {table.at("wavevector"), table.at("C1D"), {}, roughness::Density::C1D};
    const auto n = surface.curve.wavevector.size();
    surface.curve.band = {surface.curve.wavevector[0], surface.curve.wavevector[n - 1]};
    if (const auto units = table.metadata.find("units"); units != table.metadata.end())
        surface.alerts.push_back({"UNIT_GUESSED", surface.name, fmt::format("{}: units {}", file, units->second), "write them in the header as q [1/m], C1D [m3]"});
}

void analyse_measurements(SurfaceResult& surface, const SurfaceInput& input, const AnalysisOptions& options, parallel::Threads threads) {
    struct Task {
        std::string file;
        std::function<PreparedMeasurement()> prepare;
    };
    std::vector<Task> tasks;
    for (const auto& measurement : input.measurements) {
        try {
            for (auto& prepare : prepared_measurements(measurement)) tasks.push_back({measurement.file, std::move(prepare)});
        } catch (const Error& error) {
            tasks.push_back({measurement.file, [message = std::string(error.what())]() -> PreparedMeasurement { throw FileError(message); }});
        }
    }
    surface.measurements.resize(tasks.size());
    const parallel::Threads inside = tasks.size() == 1 ? threads : parallel::Threads{1};
    parallel::for_each_index(tasks.size(), threads, [&](std::size_t i) {
        auto& result = surface.measurements[i];
        try {
            result = analyse_measurement(tasks[i].prepare(), options, inside);
        } catch (const Error& error) {
            result.error = error.what();
        }
        result.file = tasks[i].file;
    });
}

}  // namespace

double ParameterSpread::covariance(const Function& f, const Function& g) const {
    double sum = 0.0;
    if (replicas.size() > 1) {
        const auto n = static_cast<double>(replicas.size());
        double mean_f = 0.0, mean_g = 0.0, products = 0.0;
        for (const auto& replica : replicas) {
            mean_f += f(replica) / n;
            mean_g += g(replica) / n;
        }
        for (const auto& replica : replicas) products += (f(replica) - mean_f) * (g(replica) - mean_g);
        sum += products / (n - 1.0);
    }
    for (const auto& source : sources) sum += 0.25 * (f(source.plus) - f(source.minus)) * (g(source.plus) - g(source.minus));
    return sum;
}

double ParameterSpread::standard_error(const Function& f) const {
    return replicas.size() < 2 && sources.empty() ? undefined : std::sqrt(covariance(f, f));
}

std::optional<Interval> ParameterSpread::interval(const Function& f) const {
    if (replicas.size() < 40 || !sources.empty()) return std::nullopt;
    std::vector<double> values;
    for (const auto& replica : replicas) values.push_back(f(replica));
    std::sort(values.begin(), values.end());
    const auto at = [&](double p) { return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1) + 0.5)]; };
    return Interval{at(0.025), at(0.975), 0.95};
}

std::vector<std::function<PreparedMeasurement()>> prepared_measurements(const MeasurementInput& input) {
    const io::ReadOptions options{input.size, input.unit};
    const auto channels = io::open(input.file, options);
    const bool container = io::detect_format(io::file_source(input.file)).identifier == "ce-container";
    std::vector<std::function<PreparedMeasurement()>> found;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const bool wanted = input.channel ? *input.channel == i : channels[i].info.is_height && (container || found.empty());
        if (wanted) found.push_back([channel = channels[i], input, options] { return prepare(channel, input, options); });
    }
    if (found.empty())
        throw InvalidArgument(input.channel ? fmt::format("{}: no channel {}, it has {}", input.file, *input.channel, channels.size())
                                            : fmt::format("{}: none of its {} channels holds heights", input.file, channels.size()));
    return found;
}

MeasurementResult analyse_measurement(const PreparedMeasurement& prepared, const AnalysisOptions& options, parallel::Threads threads) {
    const auto& measurement = prepared.measurement;
    MeasurementResult result;
    result.file = topography::metadata(measurement).file;
    result.name = topography::metadata(measurement).name;
    result.trend = prepared.trend;
    result.alerts = prepared.alerts;
    result.real_space = roughness::real_space_parameters(measurement, threads);
    result.arithmetic_height = roughness::arithmetic_height(measurement, result.real_space.mean_height);
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) result.triangulated = roughness::triangulated_area(*map, threads);
    const auto [nx, ny] = topography::shape(measurement);
    if (nx * ny > 64) {
        result.slopes = roughness::slope_distribution(measurement);
        result.alerts.insert(result.alerts.end(), result.slopes->alerts.begin(), result.slopes->alerts.end());
    }
    spectra::SpectrumOptions spectrum;
    spectrum.window = options.window;
    spectrum.contour = options.contours;
    spectrum.reliability = reliability(options);
    spectrum.threads = threads;
    result.spectrum = spectra::power_spectrum(measurement, spectrum);
    result.bands_of_uncertain_tip = bands_of_uncertain_tip(measurement, spectrum.reliability, threads);
    result.alerts.insert(result.alerts.end(), result.spectrum.alerts.begin(), result.spectrum.alerts.end());
    return result;
}

SurfaceResult analyse_surface(const SurfaceInput& input, const AnalysisOptions& options, parallel::Threads threads) {
    SurfaceResult surface;
    surface.name = input.name;
    try {
        if (input.moments) {
            analyse_moments(surface, *input.moments, options);
        } else if (input.power_spectrum) {
            analyse_power_spectrum(surface, *input.power_spectrum);
        } else {
            analyse_measurements(surface, input, options, threads);
            analyse_combined(surface, options, threads);
        }
        surface.uncut_energy_per_modulus = roughness::spectral_parameters(surface.curve, options.conversion).elastic_energy_per_modulus;
        surface.curve = roughness::limited(surface.curve, options.limits);
        surface.parameters = roughness::spectral_parameters(surface.curve, options.conversion);
        if (surface.curve.density == roughness::Density::C1D) {
            const bool exact = options.conversion == roughness::Conversion::exact;
            surface.other_conversion = roughness::spectral_parameters(surface.curve, exact ? roughness::Conversion::eq11 : roughness::Conversion::exact);
        }
    } catch (const Error& error) {
        surface.error = error.what();
    }
    return surface;
}

SpectralParameters parameters_within(const SurfaceResult& surface, const roughness::WavelengthLimits& limits, roughness::Conversion conversion) {
    return roughness::spectral_parameters(roughness::limited(surface.curve, limits), conversion);
}

}  // namespace setae::workflow
