// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/parameter_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::file_figures {
namespace {

constexpr Index max_rows = 200;

/// The curve with more nodes on its power laws, so that shares between few rows of a table are those of the curve.
spectra::Spectrum refined(spectra::Spectrum curve) {
    if (curve.nodes == spectra::Nodes::modes) return curve;
    const auto& q = curve.wavevector;
    std::vector<double> nodes(q.begin(), q.end());
    const double step = std::log(curve.band.upper / curve.band.lower) / static_cast<double>(max_rows);
    for (Index i = 0; i < max_rows; ++i) {
        const double at = curve.band.lower * std::exp(step * (static_cast<double>(i) + 0.5));
        const auto above = std::upper_bound(q.begin(), q.end(), at);
        const bool gap = above == q.begin() || above == q.end() || std::log(*above / *(above - 1)) > step;
        if (gap) nodes.push_back(at);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    spectra::Spectrum result{.band = curve.band, .kind = curve.kind, .waves_end = curve.waves_end};
    result.wavevector = Eigen::Map<const Array1D>(nodes.data(), static_cast<Index>(nodes.size()));
    result.density = roughness::values_at(curve, result.wavevector);
    for (Index i = 0; i < q.size(); ++i)
        result.density[std::lower_bound(nodes.begin(), nodes.end(), q[i]) - nodes.begin()] = curve.density[i];
    return result;
}

/// Rows to draw: from the first visible share on, at most max_rows in even steps of ln q.
std::vector<Index> rows_of(const roughness::CumulativeParameters& below) {
    constexpr double seen = 1e-3;
    const auto last = below.wavevector.size() - 1;
    const double step = std::log(below.wavevector[last] / below.wavevector[0]) / static_cast<double>(max_rows);
    std::vector<Index> rows;
    double next = 0.0;
    for (Index i = 0; i <= last; ++i) {
        const double height = below.rms_height[i] / below.rms_height[last];
        if (height * height < seen || (below.wavevector[i] < next && i != last)) continue;
        next = below.wavevector[i] * std::exp(step);
        rows.push_back(i);
    }
    return rows;
}

}  // namespace

StudyFigure parameter_figure(const study::SurfaceResult& surface, const Look& look) {
    const auto& spectrum = surface.used();
    const auto below = roughness::cumulative_parameters(refined(spectrum.curve));
    const auto rows = rows_of(below);
    const auto last = below.wavevector.size() - 1;
    const Array1D wavelength = 2.0 * pi / below.wavevector(rows);
    const auto length = axis_unit(Array1D{{std::sqrt(wavelength.maxCoeff() * wavelength.minCoeff())}}, "m");
    figures::Panel panel{.x = {.quantity = "wavelength *λ*", .unit = length.name, .logarithmic = true},
                         .y = {.quantity = "share from waves longer than *λ*", .unit = "%", .from = 0.0, .to = 103.0}};
    const auto add = [&](const char* label, const Array1D& values, double power) {
        panel.series.push_back({.label = label,
                                .x = wavelength / length.factor,
                                .y = 100.0 * (values(rows) / values[last]).pow(power),
                                .mark = figures::Mark::line});
    };
    add("mean square height", below.rms_height, 2.0);
    add("stored energy", below.elastic_energy_per_modulus, 1.0);
    add("mean square slope", below.rms_slope, 2.0);
    add("mean square curvature", below.rms_curvature, 2.0);
    const auto single = surface.measurements.size() == 1;
    StudyFigure drawn{.identifier = "parameters", .name = "parameters", .command = look.command};
    drawn.title =
        single ? "Contributions of wavelengths to the roughness of " + file_name(surface.measurements.front().file)
               : "Contributions of wavelengths to the roughness";
    const auto& p = spectrum.parameters;
    drawn.caption = fmt::format(
        "Shares of h_rms² (h_rms = {}), stored energy U_el (U_el/(A E*) = {}), h'_rms² (h'_rms = {:.3g}) and h''_rms² (h''_rms = {}) from "
        "waves longer than λ. The shares include waves between {} and {}; waves outside this band are not measured.",
        format_value(p.rms_height, "m", 3), format_value(p.elastic_energy_per_modulus, "m", 3), p.rms_slope,
        format_value(p.rms_curvature, "1/m", 3), format_value(2.0 * pi / spectrum.curve.band.upper, "m", 3),
        format_value(2.0 * pi / spectrum.curve.band.lower, "m", 3));
    drawn.figure = {
        .panels = {panel}, .width_mm = look.wide() ? 140.0 : column_mm, .height_mm = look.wide() ? 95.0 : 70.0};
    figures::put_legend_above(drawn.figure);
    return drawn;
}

}  // namespace setae::file_figures
