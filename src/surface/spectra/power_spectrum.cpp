// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/power_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "checks.hpp"
#include "line_coherence.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/spectra/polyline.hpp"
#include "setae/spectra/segment_response.hpp"
#include "trace_correction.hpp"

namespace setae::spectra {
namespace {

Array1D modes(Index count, double length) {
    return Array1D::LinSpaced(count, 1.0, static_cast<double>(count)) * (2.0 * pi / length);
}

template <class Kind>
void describe(MeasuredSpectrum& spectrum, const Kind& measurement, const ReliableBand& reliable, double length,
              Window window) {
    spectrum.band = reliable.band;
    spectrum.alerts = reliable.alerts;
    spectrum.length = length;
    spectrum.window = name(window);
    spectrum.metadata = measurement.metadata;
}

template <class Kind>
MeasuredSpectrum empty_spectrum(const Kind& measurement, double length, Window window, const SpectrumOptions& options) {
    MeasuredSpectrum spectrum;
    spectrum.nodes = Nodes::modes;
    describe(spectrum, measurement, reliable_band(measurement, options.reliability, options.threads), length, window);
    return spectrum;
}

/// Sums over the lines of a map: |transform|², mode by mode, and their coherence.
struct LineSums {
    LineSums(Index points, Index lines) : power(Array1D::Zero(points / 2 + 1)), coherence(points, lines) {}

    Array1D power;
    LineCoherence coherence;
};

/// Preparation of every line before its transform.
struct LinePreparation {
    Array1D window;
    bool remove_mean = false;
};

/// Adds the lines of a band, the first of them `first`, in an order that does not depend on threads.
void add_lines(LineSums& sums, const ArrayView2D& heights, Index first, const LinePreparation& preparation,
               const topography::Metadata& metadata, parallel::Threads threads) {
    const Index modes = heights.rows() / 2 + 1, blocks = fourier::block_count(heights.cols());
    Array2D power(blocks, modes);
    const auto prepare = [&](Index j, double* values) {
        Eigen::Map<Array1D> line(values, heights.rows());
        const double mean = line.mean();
        if (!std::isfinite(mean)) throw_undefined(metadata, fmt::format("line {} along x", first + j));
        line = (line - (preparation.remove_mean ? mean : 0.0)) * preparation.window;
    };
    const auto consume = [&](const fourier::SpectrumBlock& block) {
        double* power_row = power.row(block.index).data();
        std::fill_n(power_row, modes, 0.0);
        for (Index m = 0; m < block.lines; ++m) {
            const fourier::Complex* line = block.line(m);
            sums.coherence.take(first + block.first + m, line);
            for (Index k = 0; k < modes; ++k)
                power_row[k] += line[k].real() * line[k].real() + line[k].imag() * line[k].imag();
        }
    };
    fourier::transform_lines(heights, prepare, consume, threads);
    for (Index b = 0; b < blocks; ++b) sums.power += power.row(b).transpose();
}

bool needs_fit(topography::Trend trend) {
    return trend == topography::Trend::tilt || trend == topography::Trend::parabola;
}

/// C1D, its standard error and count from sums over the lines of n points.
void fill_from_sums(MeasuredSpectrum& spectrum, LineSums& sums, Index n, Index lines, parallel::Threads threads) {
    const Index count = n / 2;
    const double step = spectrum.length / static_cast<double>(n), factor = step * step / spectrum.length;
    const double number = static_cast<double>(lines);
    spectrum.wavevector = modes(count, spectrum.length);
    spectrum.density = sums.power.tail(count) * (factor / number);
    spectrum.count = Array1D::Constant(count, number);
    spectrum.independent_lines = lines > 1 ? sums.coherence.independent_lines(threads) : Array1D::Ones(count);
    spectrum.standard_error =
        lines > 1 ? Array1D(spectrum.density / spectrum.independent_lines.sqrt()) : Array1D::Constant(count, undefined);
}

/// C1D from the lines of a map after removal of a trend other than the mean.
void fill_from_lines(MeasuredSpectrum& spectrum, const ArrayView2D& heights, Window window,
                     const SpectrumOptions& options) {
    LineSums sums(heights.rows(), heights.cols());
    add_lines(sums, heights, 0, {window_values(window, heights.rows()), options.trend != topography::Trend::none},
              spectrum.metadata, options.threads);
    fill_from_sums(spectrum, sums, heights.rows(), heights.cols(), options.threads);
}

void require_line_window(Window window) {
    if (window == Window::radial_hann)
        throw InvalidArgument("window radial_hann for line scans; expected none, hann or blackman_harris");
}

template <class Uniform>
void require_uniform(const Uniform& measurement, Window window) {
    require_shape(measurement);
    require_line_window(window);
}

/// Size of the correction for the straight segments of a contour, below `end` [1/m].
Alert contour_alert(const MeasuredSpectrum& corrected, const Array1D& response, double end) {
    const Array1D q2 = corrected.wavevector.square();
    const Array1D power =
        corrected.wavevector.unaryExpr([&](double q) { return q <= end ? 1.0 : 0.0; }) * corrected.density;
    const auto rms_change = [&](const Array1D& weight) {
        return 100.0 * (std::sqrt((weight * power).sum() / (weight * power * response).sum()) - 1.0);
    };
    const auto last = response.size() - 1;
    return {"CONTOUR_STEPS", topography::label(corrected.metadata),
            fmt::format("straight segments between the points retain {:.0f} % of C1D at {:.3g} 1/m; the correction "
                        "raises the rms slope of this profile by {:.1f} % and the rms curvature by {:.1f} %",
                        100.0 * response[last], corrected.wavevector[last], rms_change(q2), rms_change(q2.square())),
            "trace with finer steps, or choose segments if the polyline itself is the surface"};
}

/// At chosen wavevectors the band cannot be determined: it is that of the modes.
void take_band_of_modes(MeasuredSpectrum& spectrum, const topography::Profile& profile, SpectrumOptions options) {
    options.wavevectors.reset();
    const auto of_modes = power_spectrum(profile, options);
    spectrum.band.upper = of_modes.band.upper;
    const auto is_trace = [](const Alert& alert) { return alert.code == "TRACE_NOISE"; };
    *std::find_if(spectrum.alerts.begin(), spectrum.alerts.end(), is_trace) =
        *std::find_if(of_modes.alerts.begin(), of_modes.alerts.end(), is_trace);
}

}  // namespace

MeasuredSpectrum power_spectrum(const topography::LineScan& scan, const SpectrumOptions& options) {
    const auto window = resolved(options.window, scan.periodic);
    require_uniform(scan, window);
    auto spectrum = empty_spectrum(scan, scan.size, window, options);
    require_defined(scan.heights, scan.metadata);
    const auto detrended = topography::detrended(scan, options.trend);
    fill_from_lines(spectrum, Eigen::Map<const Array2D>(detrended.heights.data(), detrended.heights.size(), 1), window,
                    options);
    return spectrum;
}

MeasuredSpectrum power_spectrum(const topography::HeightMap& map, const SpectrumOptions& options) {
    const auto window = resolved(options.window, map.periodic);
    require_uniform(map, window);
    auto spectrum = empty_spectrum(map, map.size[0], window, options);
    spectrum.pitch = map.pixel_size()[1];
    if (needs_fit(options.trend))
        fill_from_lines(spectrum, topography::detrended(map, options.trend).heights, window, options);
    else fill_from_lines(spectrum, map.heights, window, options);
    return spectrum;
}

MeasuredSpectrum power_spectrum(const topography::TiledMap& map, Index lines_together, const SpectrumOptions& options) {
    const auto window = resolved(options.window, map.periodic);
    require_line_window(window);
    const auto levelled =
        needs_fit(options.trend) ? topography::detrended(map, options.trend, lines_together, options.threads) : map;
    MeasuredSpectrum spectrum;
    spectrum.nodes = Nodes::modes;
    describe(spectrum, map, reliable_band(map, lines_together, options.reliability, options.threads), map.size[0],
             window);
    spectrum.pitch = map.pixel_size()[1];
    LineSums sums(map.nx, map.ny);
    const LinePreparation preparation{window_values(window, map.nx), options.trend != topography::Trend::none};
    for (Index first = 0; first < map.ny; first += lines_together)
        add_lines(sums, levelled.lines(first, std::min(lines_together, map.ny - first)), first, preparation,
                  map.metadata, options.threads);
    fill_from_sums(spectrum, sums, map.nx, map.ny, options.threads);
    return spectrum;
}

MeasuredSpectrum power_spectrum(const topography::Profile& profile, const SpectrumOptions& options) {
    topography::validate(profile);
    require_defined(profile.heights, profile.metadata);
    const auto window = resolved(options.window, false);
    auto spectrum = empty_spectrum(profile, profile.size(), window, options);
    const double steps = static_cast<double>(profile.positions.size() - 1);
    spectrum.wavevector = options.wavevectors
                              ? *options.wavevectors
                              : modes(std::max<Index>(1, static_cast<Index>(0.5 * steps)), spectrum.length);
    spectrum.density = polyline_power_spectrum(topography::detrended(profile, options.trend), spectrum.wavevector,
                                               window, options.threads);
    spectrum.count = Array1D::Ones(spectrum.wavevector.size());
    spectrum.independent_lines = spectrum.count;
    spectrum.standard_error = Array1D::Constant(spectrum.wavevector.size(), undefined);
    const bool sampled = options.contour == ContourTreatment::sinc_corrected,
               free_of_trace = options.trace_response && profile.response;
    if (!sampled && !free_of_trace) return spectrum;

    const SegmentResponse segments(profile.positions);
    const Array1D response =
        segments.at(spectrum.wavevector, segments.fitted_exponent(spectrum.wavevector, spectrum.density));
    if (sampled) spectrum.density /= response;
    if (free_of_trace) {
        const Array1D all = Array1D::Ones(response.size());
        correct_for_trace(spectrum, *profile.response, sampled ? all : response);
        if (options.wavevectors) take_band_of_modes(spectrum, profile, options);
    }
    if (sampled && spectrum.band.upper > 0.0)
        spectrum.alerts.push_back(contour_alert(
            spectrum, response, free_of_trace ? spectrum.band.upper : std::numeric_limits<double>::infinity()));
    return spectrum;
}

MeasuredSpectrum power_spectrum(const topography::Measurement& measurement, const SpectrumOptions& options) {
    return std::visit([&](const auto& m) { return power_spectrum(m, options); }, measurement);
}

MeasuredSpectrum within_band(MeasuredSpectrum spectrum) {
    std::vector<Index> kept;
    for (Index k = 0; k < spectrum.wavevector.size(); ++k)
        if (in_band(spectrum.wavevector[k], spectrum.band.lower, spectrum.band.upper)) kept.push_back(k);
    for (Array1D* column : {&spectrum.wavevector, &spectrum.density, &spectrum.standard_error, &spectrum.count,
                            &spectrum.independent_lines}) {
        if (column->size() == 0) continue;
        const Array1D part = (*column)(kept);
        *column = part;
    }
    const auto& q = spectrum.wavevector;
    if (q.size() > 0) spectrum.band.lower = q[0] - 0.5 * (q.size() > 1 ? q[1] - q[0] : q[0]);
    return spectrum;
}

}  // namespace setae::spectra
