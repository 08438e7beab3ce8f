// SPDX-License-Identifier: GPL-3.0-or-later
#include "observed_groups.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contour_kernel.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/parametric_noise.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/spectral_fit/scan_kernel.hpp"
#include "setae/topography/trace_response.hpp"
#include "skewness.hpp"

namespace setae::spectral_fit {
namespace {

/// Relative error of the noise of a trace estimated by the scatter along its points.
constexpr double noise_error_of_traces = 0.2;

int trend_degree(const ObservedSurface& observed) {
    return std::max(observed.trend == topography::Trend::parabola ? 2 : 1, observed.trend_degree);
}

topography::HeightMap as_map(const topography::LineScan& scan) {
    topography::HeightMap map{Eigen::Map<const Array2D>(scan.heights.data(), scan.heights.size(), 1),
                              {scan.size, scan.pixel_size()},
                              false,
                              scan.metadata};
    return map;
}

double length_of(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return map->size[0];
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement)) return scan->size;
    return std::get<topography::Profile>(measurement).size();
}

/// Nodes and response of an equidistant class, with the constant part and the end at q_s included in the outer columns.
void add_response(ObservedGroup& group, const ScanShape& shape, const SpectrumRange& range, double length,
                  parallel::Threads threads) {
    const double step = group.pixel_size;
    const auto first = static_cast<Index>(std::floor(std::log(0.03 * 2.0 * pi / length * step) / node_spacing));
    const double end = std::log(range.shortest * step) / node_spacing;
    const auto last = static_cast<Index>(std::floor(end + 1e-9));
    if (last <= first + 1)
        throw InvalidArgument(fmt::format("pixels of {} m below the surface's shortest wavelength", step));
    auto kernel = scan_kernel(shape, first, last + 1, threads);
    // C continues between the last node and q_s and is 0 beyond: the hat of the next node adds the missing part
    const double rest = end - static_cast<double>(last) - 0.5;
    const Index count = last - first + 1;
    const Array1D next_node = std::exp(-2.0 * node_spacing) * kernel.response.col(count);
    kernel.response.col(count - 1) += rest * next_node;
    kernel.response.col(0) += kernel.flat_response;
    group.data.nodes =
        (Array1D::LinSpaced(count, static_cast<double>(first), static_cast<double>(last)) * node_spacing).exp() / step;
    group.data.response = kernel.response.leftCols(count) / step;
    group.end_response = next_node / step;
    group.data.noise_response = kernel.noise_response * step;
}

std::string class_name(const topography::Metadata& metadata, Index points, double size) {
    return fmt::format("{} of {} points over {:.4g} um",
                       metadata.instrument.type.empty() ? "scan" : metadata.instrument.type, points, size * 1e6);
}

/// Upper end of the information of a measurement on the surface: its sampling, its tip, and q_s, beyond which a mode
/// contains only leakage of the window.
double band_end(const ObservedSurface& observed, double nyquist, const SpectrumRange& range,
                const LikelihoodOptions& options) {
    const double sampled = std::min({nyquist, range.shortest * (1.0 + 1e-9), observed.untouched.upper});
    if (!options.tip_band) return sampled;
    return std::min(sampled, spectra::reliable_band(observed.measurement, {}, options.threads).band.upper);
}

/// Probe of the measurement.
std::optional<Probe> probe_of(const ObservedSurface& observed, const topography::Instrument& instrument) {
    if (observed.probe || !instrument.tip_radius) return observed.probe;
    return sphere(
        {.value = *instrument.tip_radius, .standard_error = instrument.tip_radius_standard_error.value_or(0.0)});
}

/// Name of the size of a probe: as given with the measurement, otherwise by its instrument and shape.
std::string probe_input(const ObservedSurface& observed, const std::optional<Probe>& probe,
                        const topography::Instrument& instrument) {
    if (!probe || !(probe->size_error > 0.0)) return {};
    if (!observed.probe_input.empty()) return observed.probe_input;
    return fmt::format("{}{} ({})", probe->is_foil() ? "foil thickness" : "tip radius",
                       instrument.type.empty() ? "" : " of " + instrument.type, probe->name);
}

bool same(const SharedFactor& a, const SharedFactor& b) {
    return a.input == b.input && a.relative_error == b.relative_error;
}

std::string name_of(const std::optional<Probe>& probe) { return probe ? probe->name : std::string(); }

bool same(const std::optional<OpticalTransfer>& a, const std::optional<OpticalTransfer>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return a->numerical_aperture == b->numerical_aperture && a->light_wavelength == b->light_wavelength;
}

/// Applies T² of an optical profiler to the power of the waves.
void look_through(ObservedGroup& group, const OpticalTransfer& optics) {
    const Array1D transfer = group.data.nodes.unaryExpr([&](double q) { return optics.at(q); });
    group.data.response.rowwise() *= transfer.square().transpose();
    group.optics = optics;
}

/// Name, instrument and wavevectors of the groups of modes over a length.
ObservedGroup described(const topography::Metadata& metadata, Index points, double length, const ModeBins& bins) {
    const auto& instrument = metadata.instrument;
    ObservedGroup group;
    group.data.instrument = instrument.type;
    group.data.name = class_name(metadata, points, length);
    group.data.wavevector =
        Array1D::NullaryExpr(bins.size(), [&](Index b) { return 2.0 * pi / length * bins.centre(b); });
    group.mode_counts = Array1D::NullaryExpr(bins.size(), [&](Index b) { return static_cast<double>(bins.count(b)); });
    group.independent_share = Array1D::Constant(bins.size(), spectra::share_under_hann);
    return group;
}

void add_uniform(std::vector<ObservedGroup>& groups, topography::HeightMap map, const ObservedSurface& observed,
                 const SpectrumRange& range, const LikelihoodOptions& options) {
    const double pitch = map.pixel_size()[1];
    GappedLines gaps;
    if (map.heights.isNaN().any()) {
        auto bridged = bridged_lines(map.heights, topography::label(map.metadata));
        map.heights = std::move(bridged.heights);
        gaps = std::move(bridged.gaps);
    }
    const ScanShape shape{map.heights.rows(), trend_degree(observed)};
    const auto& instrument = map.metadata.instrument;
    const auto probe = probe_of(observed, instrument);
    const auto input = probe_input(observed, probe, instrument);
    const double step = map.pixel_size()[0];
    const Array1D periodogram = scan_periodogram(map.heights, step, shape.trend_degree, options.threads);
    const double end = band_end(observed, pi / step * (1.0 + 1e-9), range, options);
    const std::string name = class_name(map.metadata, map.heights.rows(), map.size[0]);
    auto place = std::find_if(groups.begin(), groups.end(), [&](const ObservedGroup& g) {
        return !g.contour && g.data.name == name && g.data.instrument == instrument.type &&
               g.lines == map.heights.cols() && g.trend_degree == shape.trend_degree &&
               g.direction == observed.direction && name_of(g.probe) == name_of(probe) && g.probe_input == input &&
               same(g.height, observed.height) && same(g.lateral, observed.lateral) &&
               same(g.optics, observed.optics) && std::abs(g.pixel_size / step - 1.0) < 1e-6 &&
               g.data.periodogram.size() == periodogram.size();
    });
    if (place == groups.end()) {
        const ModeBins bins(shape.points / 2);
        auto group = described(map.metadata, shape.points, map.size[0], bins);
        group.pixel_size = step;
        group.lines = map.heights.cols();
        group.pitch = pitch;
        group.trend_degree = shape.trend_degree;
        group.direction = observed.direction;
        group.probe = probe;
        group.probe_input = input;
        group.height = observed.height;
        group.lateral = observed.lateral;
        add_response(group, shape, range, map.size[0], options.threads);
        if (observed.optics) look_through(group, *observed.optics);
        group.data.periodogram = Array1D::Zero(bins.size());
        groups.push_back(std::move(group));
        place = groups.end() - 1;
    }
    place->band_begin = std::max(place->band_begin, observed.untouched.lower);
    if (place->probe) place->skewness.push_back(skewness_of(map.heights));
    if (gaps.undefined.cols() > 0) place->gaps.push_back(std::move(gaps));
    place->periodograms.push_back(periodogram);
    const double n = ++place->measurements;
    place->data.periodogram += (periodogram - place->data.periodogram) / n;
    place->band_end = std::exp(((n - 1.0) * std::log(n > 1.0 ? place->band_end : 1.0) + std::log(end)) / n);
}

void add_curve(std::vector<ObservedGroup>& groups, const topography::Profile& curve, const ObservedSurface& observed,
               const Array1D& nodes, const SpectrumRange& range, const LikelihoodOptions& options) {
    auto kernel = contour_kernel(curve, nodes, options.threads);
    auto group = described(curve.metadata, curve.positions.size(), kernel.length, kernel.bins);
    group.data.nodes = nodes;
    group.data.response = std::move(kernel.response);
    group.contour = &curve;
    group.probe = probe_of(observed, curve.metadata.instrument);
    group.probe_input = probe_input(observed, group.probe, curve.metadata.instrument);
    group.height = observed.height;
    group.lateral = observed.lateral;
    group.direction = observed.direction;
    group.pixel_size = kernel.length / static_cast<double>(curve.positions.size() - 1);
    if (kernel.noise.size() > 0 && kernel.noise.maxCoeff() > 0.0) {
        group.data.noise_response = std::move(kernel.noise);
        group.data.noise_prior_deviation = noise_error_of_traces;
    } else if (curve.metadata.instrument.type != "tem") {
        group.data.noise_response = white_noise(curve, options.threads);
    }
    group.band_begin = observed.untouched.lower;
    if (observed.optics) look_through(group, *observed.optics);
    if (group.probe && !group.probe->is_foil()) group.skewness.push_back(skewness_of(curve.heights));
    group.data.periodogram = std::move(kernel.periodogram);
    group.periodograms = {group.data.periodogram};
    group.measurements = 1;
    group.band_end = band_end(observed, pi / group.pixel_size, range, options);
    if (curve.response) group.band_end = std::min(group.band_end, topography::trace_band_end(*curve.response));
    groups.push_back(std::move(group));
}

}  // namespace

SpectrumRange spectrum_range(std::span<const ObservedSurface> observed, const LikelihoodOptions& options) {
    if (observed.empty()) throw InvalidArgument("no measurement is given; fitting a spectrum needs at least one");
    if (!(options.shortest_wavelength > 0.0))
        throw InvalidArgument(fmt::format("shortest wavelength {} m; expected > 0", options.shortest_wavelength));
    double longest = 0.0;
    for (const auto& o : observed) longest = std::max(longest, length_of(o.measurement));
    return {0.6 * 2.0 * pi / longest, 2.0 * pi / options.shortest_wavelength};
}

std::vector<ObservedGroup> observed_groups(std::span<const ObservedSurface> observed, const SpectrumRange& range,
                                           const LikelihoodOptions& options) {
    const auto count =
        static_cast<Index>(std::ceil(std::log(range.shortest / (0.03 * range.lowest)) / node_spacing)) + 1;
    const Array1D nodes =
        range.shortest * (Array1D::LinSpaced(count, static_cast<double>(1 - count), 0.0) * node_spacing).exp();
    std::vector<ObservedGroup> groups;
    for (const auto& o : observed) {
        if (const auto* map = std::get_if<topography::HeightMap>(&o.measurement))
            add_uniform(groups, *map, o, range, options);
        else if (const auto* scan = std::get_if<topography::LineScan>(&o.measurement))
            add_uniform(groups, as_map(*scan), o, range, options);
        else add_curve(groups, std::get<topography::Profile>(o.measurement), o, nodes, range, options);
    }
    return groups;
}

}  // namespace setae::spectral_fit
