// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_slopes.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/roughness/true_area.hpp"

namespace setae::study {
namespace {

using roughness::SpectralParameters;

bool departs(const MeasurementResult& measurement) {
    return std::any_of(measurement.alerts.begin(), measurement.alerts.end(),
                       [](const Alert& a) { return a.code == "NON_GAUSSIAN" || a.code == "ANISOTROPIC"; });
}

/// Excess area of a shape over that of Gaussian slopes, at a slope.
double area_shape(const roughness::SlopeShape& shape, double rms_slope) {
    return (shape.area_ratio(rms_slope) - 1.0) / (roughness::gaussian_area_ratio(rms_slope) - 1.0);
}

void take_shape(SpectrumResult& spectrum, const roughness::SlopeShape& shape) {
    const double factor = area_shape(shape, spectrum.parameters.rms_slope);
    const auto take = [factor](SpectralParameters& parameters) { parameters.area_shape = factor; };
    take(spectrum.parameters);
    if (spectrum.other_conversion) take(*spectrum.other_conversion);
    spectrum.spread.each(take);
}

}  // namespace

void use_measured_slopes(SurfaceResult& surface) {
    constexpr double most = 0.5;
    std::vector<roughness::WeighedShape> shapes;
    double area = 0.0, departing = 0.0;
    for (const auto& measurement : surface.measurements) {
        if (!measurement.slope_shape) continue;
        shapes.push_back(*measurement.slope_shape);
        area += shapes.back().area;
        if (departs(measurement)) departing += shapes.back().area;
    }
    if (shapes.empty() || !(surface.used().parameters.rms_slope > 0.0)) return;
    surface.slope_shape = roughness::mean_shape(shapes);
    const bool stretched = surface.fitted && !surface.fitted->stretch.empty();
    if (!stretched && !(departing > most * area)) return;
    take_shape(surface.average, *surface.slope_shape);
    if (surface.likelihood) take_shape(*surface.likelihood, *surface.slope_shape);
    surface.alerts.push_back(
        {"MEASURED_SLOPES", surface.name,
         fmt::format("the slopes of the maps are not Gaussian and isotropic: by their measured distribution, "
                     "A_true/A_app − 1 is {:.3g} times the value of Eq. 9",
                     surface.used().parameters.area_shape),
         "to compare with Eq. 9, use true_area_ratio_gaussian; A_true/A_app uses the measured "
         "distribution"});
}

}  // namespace setae::study
