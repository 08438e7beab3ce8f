// SPDX-License-Identifier: GPL-3.0-or-later
#include "contour_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "curve_distance.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/real_space.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/traced_curve.hpp"

namespace setae::validation {
namespace {

using simulation::PixelCurve;
using topography::TracedCurve;

constexpr double metres = 1e-9;        // a pixel is a nanometre
constexpr double traced_within = 3.0;  // px
constexpr double border = 4.0;         // px: the curve need not be found closer to the picture's border
constexpr double min_false = 1.0;      // px
constexpr double longest_noise_wave = 200.0, shortest_noise_wave = 50.0;  // px: smoothing leaves these as they are
constexpr double above_floor = 10.0;
constexpr double min_density = 1e-4;  // px³: lower limit for pictures without noise
constexpr int cells_per_decade = 10;

PixelCurve curve_of(const imaging::ContourSegment& segment) { return {segment.x, segment.y}; }

/// Signed distances of the trace's points from the curve.
struct Distances {
    Array1D of_trace;
    std::vector<NearestPlace> places;
};

Distances distances(const PixelCurve& trace, const CurveIndex& truth) {
    Distances result{Array1D(trace.x.size()), {}};
    for (Index i = 0; i < trace.x.size(); ++i) {
        result.places.push_back(truth.nearest(trace.x[i], trace.y[i]));
        result.of_trace[i] = result.places.back().distance;
    }
    return result;
}

/// Signed distances of the curve's points within the picture from the nearest segment of the trace.
Array1D distances_of_true_curve(const imaging::ContourTrace& trace, const RenderedContour& rendered) {
    std::vector<CurveIndex> segments;
    for (const auto& segment : trace.segments)
        if (segment.x.size() >= 2) segments.emplace_back(curve_of(segment));
    std::vector<double> found;
    const auto& curve = rendered.truth.curve;
    for (Index i = 0; i < curve.x.size(); ++i) {
        const double x = curve.x[i], y = curve.y[i];
        if (x < border || y < border || x > static_cast<double>(rendered.width - 1) - border ||
            y > static_cast<double>(rendered.height - 1) - border)
            continue;
        double nearest = std::hypot(static_cast<double>(rendered.width), static_cast<double>(rendered.height));
        for (const auto& segment : segments)
            if (const double distance = segment.nearest(x, y).distance; std::abs(distance) < std::abs(nearest))
                nearest = distance;
        found.push_back(nearest);
    }
    return Eigen::Map<const Array1D>(found.data(), static_cast<Index>(found.size()));
}

double rms(const Array1D& values) { return std::sqrt(values.square().mean()); }

/// The part of the curve that the trace covers, between the positions nearest to its ends.
PixelCurve covered_part(const PixelCurve& truth, NearestPlace begin, NearestPlace end) {
    if (begin.segment > end.segment) std::swap(begin, end);
    if (begin.segment == end.segment) return truth;
    const Index inner = end.segment - begin.segment;
    PixelCurve part{Array1D(inner + 2), Array1D(inner + 2)};
    part.x << begin.x, truth.x.segment(begin.segment + 1, inner), end.x;
    part.y << begin.y, truth.y.segment(begin.segment + 1, inner), end.y;
    return part;
}

TracedCurve in_metres(const PixelCurve& curve) { return {.x = metres * curve.x, .y = -metres * curve.y}; }

TracedCurve in_metres(const imaging::ContourTrace& trace) {
    const auto& segment = trace.segments.front();
    auto curve = in_metres(curve_of(segment));
    if (segment.standard_error.size() == segment.x.size()) curve.standard_error = metres * segment.standard_error;
    curve.closed = segment.closed;
    const double step = segment.length / static_cast<double>(segment.x.size() - 1);
    curve.response = topography::TraceResponse{.blur = metres * segment.edge_width,
                                               .smoothing_length = metres * segment.smoothing_length,
                                               .step = metres * step,
                                               .noise_density = metres * metres * metres * segment.noise_density};
    return curve;
}

/// Mean C1D over modes between two wavevectors; NaN where there is none.
double mean_between(const spectra::MeasuredSpectrum& spectrum, double lower, double upper) {
    double sum = 0.0;
    int count = 0;
    for (Index k = 0; k < spectrum.wavevector.size(); ++k)
        if (spectrum.wavevector[k] >= lower && spectrum.wavevector[k] < upper) {
            sum += spectrum.density[k];
            ++count;
        }
    return count > 0 ? sum / count : undefined;
}

/// Ratios of spectra in half decades, over tenths of a decade with waves of the curve above the floor.
std::array<double, 5> spectrum_ratios(const topography::Profile& traced, const topography::Profile& known,
                                      double shortest_wave) {
    const double length = traced.size(), shortest = shortest_compared_wave * metres;
    const auto modes = static_cast<Index>(length / shortest);
    const Array1D q = Array1D::LinSpaced(modes, 1.0, static_cast<double>(modes)) * (2.0 * pi / length);
    const spectra::SpectrumOptions options{.wavevectors = q, .threads = {1}};
    const auto found = spectra::power_spectrum(traced, options),
               expected_spectrum = spectra::power_spectrum(known, options);
    std::array<double, 5> ratios{};
    for (std::size_t band = 0; band < ratios.size(); ++band) {
        const double lower = 2.0 * pi / (spectrum_band_ends[band] * metres);
        const double upper =
            2.0 * pi / (metres * (band + 1 < ratios.size() ? spectrum_band_ends[band + 1] : shortest_compared_wave));
        const int cells = std::max(1, static_cast<int>(std::lround(cells_per_decade * std::log10(upper / lower))));
        double sum = 0.0;
        int count = 0;
        for (int cell = 0; cell < cells; ++cell) {
            const double from = lower * std::pow(upper / lower, static_cast<double>(cell) / cells),
                         to = lower * std::pow(upper / lower, static_cast<double>(cell + 1) / cells);
            if (to * shortest_wave * metres > 2.0 * pi * (1.0 + 1e-9)) continue;
            const double expected = mean_between(expected_spectrum, from, to);
            const double floor = traced.response ? traced.response->noise_density *
                                                       std::exp(std::pow(0.5 * (from + to) * traced.response->blur, 2))
                                                 : 0.0;
            if (!(expected > above_floor * floor)) continue;
            sum += mean_between(found, from, to) / expected;
            ++count;
        }
        ratios[band] = count > 0 ? sum / count : undefined;
    }
    return ratios;
}

/// C1D [px³] of the trace's errors along its length.
double error_density(const Array1D& errors, double length) {
    const auto spectrum =
        spectra::power_spectrum(topography::LineScan{.heights = errors, .size = length}, {.threads = {1}});
    return mean_between(spectrum, 2.0 * pi / longest_noise_wave, 2.0 * pi / shortest_noise_wave);
}

void compare_overhangs(ContourTrial& trial, const topography::LevelledCurve& levelled, const PixelCurve& trace,
                       const std::vector<simulation::Overhang>& known) {
    const CurveIndex index(trace);
    const Array1D along = length_along(trace);
    std::vector<bool> real(levelled.reentrant.size(), false);
    double depths = 0.0;
    for (const auto& overhang : known) {
        const auto nearest = index.nearest(overhang.x, overhang.y);
        const double at = along[nearest.segment];
        bool found = false;
        for (std::size_t k = 0; k < real.size(); ++k) {
            const auto& stretch = levelled.reentrant[k];
            if (at < stretch.begin / metres - traced_within || at > stretch.end / metres + traced_within) continue;
            real[k] = true;
            if (found || stretch.depth / metres < 0.5 * overhang.depth) continue;
            found = true;
            depths += stretch.depth / metres / overhang.depth;
        }
        if (found) ++trial.overhangs_found;
    }
    trial.overhangs = static_cast<int>(known.size());
    trial.overhang_depth_ratio = trial.overhangs_found > 0 ? depths / trial.overhangs_found : undefined;
    for (std::size_t k = 0; k < real.size(); ++k)
        if (!real[k] && levelled.reentrant[k].depth / metres > min_false) ++trial.overhangs_false;
}

}  // namespace

ContourTrial compared(const imaging::ContourTrace& trace, const RenderedContour& rendered) {
    if (trace.segments.empty() || trace.segments.front().x.size() < 3)
        throw UndefinedDataError("a trace without a segment; expected the contour");
    const auto& segment = trace.segments.front();
    const auto curve = curve_of(segment);
    const auto there = distances(curve, CurveIndex(rendered.truth.curve));
    const Array1D back = distances_of_true_curve(trace, rendered);

    ContourTrial trial{.segments = static_cast<int>(trace.segments.size()),
                       .smoothing_length = segment.smoothing_length,
                       .edge_width = segment.edge_width};
    trial.vacuum_mistaken = there.places.front().segment > there.places.back().segment;
    trial.completeness = (back.abs() < traced_within).cast<double>().mean();
    trial.rms_error = std::max(rms(there.of_trace), rms(back));
    trial.largest_error = std::max(there.of_trace.abs().maxCoeff(), back.abs().maxCoeff());
    trial.offset = there.of_trace.mean();
    trial.within_two_errors = segment.standard_error.size() == there.of_trace.size()
                                  ? (there.of_trace.abs() < 2.0 * segment.standard_error).cast<double>().mean()
                                  : undefined;

    const double length = length_along(curve).tail(1)[0];
    trial.floor_ratio =
        segment.noise_density > min_density ? error_density(there.of_trace, length) / segment.noise_density : undefined;
    const auto traced = in_metres(trace),
               known = in_metres(covered_part(rendered.truth.curve, there.places.front(), there.places.back()));
    compare_overhangs(trial, levelled(traced, topography::Reentrance::envelope), curve, rendered.truth.overhangs);
    const auto profile = levelled(traced, topography::Reentrance::cut).profile,
               expected = levelled(known, topography::Reentrance::cut).profile;
    trial.rms_height_ratio =
        roughness::real_space_parameters(profile).rms_height / roughness::real_space_parameters(expected).rms_height;
    trial.spectrum_ratio = spectrum_ratios(profile, expected, rendered.shortest_wave);
    return trial;
}

}  // namespace setae::validation
