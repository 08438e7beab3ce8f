// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "json_support.hpp"
#include "setae/output/json.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::output {

using roughness::SpectralParameters;

std::vector<Quantity> measurement_quantities(const study::MeasurementResult& m) {
    const auto& r = m.real_space;
    const bool map = !std::isnan(r.rms_slope_y);
    std::vector<Quantity> list;
    const auto term = [map](const char* name) { return std::string(map ? "areal_" : "profile_") + name; };
    const auto add = [&](Quantity q, const char* source) {
        q.source = source;
        q.n = static_cast<int>(r.defined);
        if (!std::isnan(q.estimate.value)) list.push_back(std::move(q));
    };
    add(quantity(term("rms_height"), map ? "Sq" : "Rq", r.rms_height, "m"),
        "heights, unfiltered, at the resolution of the data");
    if (map)
        add(quantity("rms_height_of_lines", "Rq", r.rms_height_of_lines, "m"),
            "lines along x, each about its own mean");
    add(quantity(term("arithmetic_height"), map ? "Sa" : "Ra", m.arithmetic_height, "m"), "heights, unfiltered");
    if (map) add(quantity("rms_slope_x", "Rdq", r.rms_slope_x, "1"), "forward differences along x");
    add(quantity(term("rms_slope"), map ? "Sdq" : "Rdq", r.rms_slope, "1"), "forward differences");
    add(quantity(term("rms_curvature"), map ? "lap/2" : "Rddq", r.rms_curvature, "1/m"), "second differences");
    if (m.triangulated)
        add(quantity("triangulated_area_ratio", "A_true/A_app", m.triangulated->area_ratio, "1"),
            "triangles through the heights; [D19], Eq. S3");
    if (m.waves_energy_per_modulus)
        add(quantity("elastic_energy_per_modulus_of_waves", "U_el/(A_app E*)", *m.waves_energy_per_modulus, "m"),
            "¼ Σ |q| |h_q|² over the map's waves of all directions inside its reliable band");
    if (m.slopes) {
        add(quantity("slope_excess_kurtosis", "kurt - 3",
                     Estimate{m.slopes->directions.front().excess_kurtosis,
                              m.slopes->directions.front().excess_kurtosis_standard_error, "jackknife over blocks"},
                     "1"),
            "slopes along x; 0 for Gaussian slopes");
        add(quantity("slope_gaussian_p_value", "p", m.slopes->gaussian_p_value, "1"),
            "skewness and excess kurtosis are 0; jackknife over blocks");
        add(quantity("slope_isotropy_ratio", "s_max/s_min", m.slopes->isotropy_ratio, "1"),
            "rms slopes of perpendicular directions");
    }
    return list;
}

std::vector<Quantity> surface_quantities(const study::SurfaceResult& surface, const study::SpectrumResult& spectrum,
                                         roughness::Conversion conversion) {
    const char* source = conversion == roughness::Conversion::exact ? exact_source : eq11_source;
    const auto make = [&](const char* name, const char* symbol, const char* unit, const char* from,
                          const roughness::ParameterSpread::Function& f, double least = 0.0) {
        auto q = quantity(name, symbol, spectrum.estimate(f, least), unit);
        q.source = from;
        q.band = spectrum.curve.band;
        if (!surface.measurements.empty())
            q.n = static_cast<int>(std::count_if(surface.measurements.begin(), surface.measurements.end(),
                                                 [](const auto& m) { return !m.failed(); }));
        return q;
    };
    const bool measured = spectrum.parameters.area_shape != 1.0;
    std::vector<Quantity> quantities{
        make("rms_height", "h_rms", "m", source, [](const SpectralParameters& p) { return p.rms_height; }),
        make("rms_slope", "h'_rms", "1", source, [](const SpectralParameters& p) { return p.rms_slope; }),
        make("rms_curvature", "h''_rms", "1/m", source, [](const SpectralParameters& p) { return p.rms_curvature; }),
        make(
            "true_area_ratio", "A_true/A_app", "1",
            measured ? "slopes distributed as the maps' of both directions" : "Gaussian isotropic slopes; [D19], Eq. 9",
            [](const SpectralParameters& p) { return p.area_ratio(); }, 1.0),
        make(
            "true_area_ratio_small_slope", "1 + h'^2/2", "1", "small slopes; [D19], Eq. S4",
            [](const SpectralParameters& p) { return roughness::small_slope_area_ratio(p.rms_slope); }, 1.0),
        make("elastic_energy_per_modulus", "U_el/(A_app E*)", "m", source,
             [](const SpectralParameters& p) { return p.elastic_energy_per_modulus; })};
    if (!surface.slope_shape) return quantities;
    if (measured)
        quantities.push_back(make(
            "true_area_ratio_gaussian", "A_true/A_app", "1", "Gaussian isotropic slopes; [D19], Eq. 9",
            [](const SpectralParameters& p) { return roughness::gaussian_area_ratio(p.rms_slope); }, 1.0));
    else
        quantities.push_back(make(
            "true_area_ratio_measured_slopes", "A_true/A_app", "1",
            "slopes distributed as the maps' of both directions",
            [&](const SpectralParameters& p) { return surface.slope_shape->area_ratio(p.rms_slope); }, 1.0));
    return quantities;
}

}  // namespace setae::output
