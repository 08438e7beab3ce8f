// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/processing/fill.hpp"
#include "setae/processing/iso_filter.hpp"
#include "setae/processing/level.hpp"
#include "setae/roughness/real_space.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/spectra/polyline.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/texture/height_parameters.hpp"
#include "setae/texture/material_ratio.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::benchmarks {
namespace {

constexpr double tip_radius = 1e-3;
constexpr Index bearing_heights = 101, polyline_wavevectors = 2000;

Array1D psd_area(const TaskInput& input) {
    (void)spectra::isotropic_power_spectrum(input.map(), {.threads = input.threads});
    return {};
}

Array1D psd_lines(const TaskInput& input) {
    (void)spectra::power_spectrum(input.map(), {.threads = input.threads});
    return {};
}

Array1D acf_area(const TaskInput& input) {
    (void)scales::autocorrelation_of_area(input.map(), {}, {.threads = input.threads});
    return {};
}

Array1D acf_lines(const TaskInput& input) {
    return scales::autocorrelation_of_lines(input.map(), {.threads = input.threads}).value.head(100);
}

Array1D variable_bandwidth(const TaskInput& input) {
    return scales::variable_bandwidth_of_area(input.map(), {.threads = input.threads}).value;
}

Array1D slope_of_lines(const TaskInput& input) {
    (void)scales::binned(
        scales::slope_from_autocorrelation(scales::autocorrelation_of_lines(input.map(), {.threads = input.threads})));
    return {};
}

Array1D differences_of_map(const TaskInput& input) {
    (void)scales::difference_statistics(input.map(), {.along = scales::Along::both, .threads = input.threads});
    return {};
}

Array1D tip_cutoff(const TaskInput& input) {
    return Array1D::Constant(1, spectra::tip_cutoff(input.map(), tip_radius, {}, {}, input.threads).value);
}

Array1D bearing_area(const TaskInput& input) {
    const auto& heights = input.map().heights;
    const Array1D levels = Array1D::LinSpaced(bearing_heights, heights.minCoeff(), heights.maxCoeff());
    return texture::bearing_area(input.map(), levels, texture::Between::linear, input.threads);
}

Array1D rms(const TaskInput& input) {
    const auto found = roughness::real_space_parameters(input.map(), input.threads);
    return Array1D{{found.rms_height, found.rms_slope, 2.0 * found.rms_curvature}};
}

Array1D polyline_psd(const TaskInput& input) {
    const auto& profile = std::get<topography::Profile>(input.measurement);
    const Array1D wavevector =
        Array1D::LinSpaced(polyline_wavevectors, std::log(2.0 * pi), std::log(2.0 * pi * 1e5)).exp();
    (void)spectra::polyline_power_spectrum(profile, wavevector, spectra::Window::hann, input.threads);
    return {};
}

Array1D fill(const TaskInput& input) {
    const auto filled = processing::filled(input.map(), input.threads);
    return filled.heights.row(filled.heights.rows() / 2).transpose();
}

Array1D moments(const TaskInput& input) {
    const auto found = texture::height_parameters(input.map(), input.threads);
    return Array1D{{found.Sa, found.Sq, found.Ssk}};
}

Array1D true_area(const TaskInput& input) {
    (void)roughness::triangulated_area(input.map(), input.threads);
    return {};
}

Array1D background(const TaskInput& input) {
    (void)processing::apply(processing::LevelPolynomial{.degree = 6, .degree_x = 3, .degree_y = 3}, input.map(),
                            input.threads);
    return {};
}

/// Of 20 pixels standard deviation, which is 0.187 of the nesting index.
Array1D gaussian(const TaskInput& input) {
    const double alpha = std::sqrt(std::log(2.0) / pi), deviation = 20.0 * input.map().pixel_size()[0];
    (void)processing::apply(processing::GaussianFilter{.cutoff = deviation * std::sqrt(2.0 * pi) / alpha}, input.map(),
                            input.threads);
    return {};
}

/// By a paraboloid of 41 x 41 pixels, as high as the rms height 20 pixels from its apex.
Array1D dilation(const TaskInput& input) {
    const auto& map = input.map();
    const double height = std::sqrt((map.heights - map.heights.mean()).square().mean());
    const auto square = [](Index i) { return std::pow(static_cast<double>(i - 20), 2); };
    const topography::ArrayTip tip{
        Array2D::NullaryExpr(41, 41, [&](Index i, Index j) { return height * (square(i) + square(j)) / 400.0; }),
        map.pixel_size(), 20, 20};
    (void)topography::dilated(map, tip, {.threads = input.threads});
    return {};
}

}  // namespace

const std::vector<Task>& tasks() {
    static const std::vector<Task> list{
        {"psd_area", "C_iso of the area, window included", psd_area},
        {"psd_lines", "C1D of its lines", psd_lines},
        {"acf_area", "autocorrelation of the area, full circle", acf_area},
        {"acf_lines", "autocorrelation of its lines", acf_lines},
        {"variable_bandwidth", "variable bandwidth of the area", variable_bandwidth},
        {"slope_of_lines", "scale-dependent slope of the lines", slope_of_lines},
        {"differences_of_map", "scale-dependent statistics of the map, default grid", differences_of_map},
        {"tip_cutoff", "tip cutoff", tip_cutoff},
        {"bearing_area", "bearing area at 101 heights", bearing_area},
        {"rms", "rms height, gradient and curvature", rms},
        {"polyline_psd", "exact spectrum of a polyline of 3000 random points at 2000 wavevectors", polyline_psd},
        {"fill", "undefined points filled", fill},
        {"moments", "mean, rms, skewness of heights", moments},
        {"true_area", "area of the triangles", true_area},
        {"background", "cubic background", background},
        {"gaussian", "Gaussian filter of 20 pixels", gaussian},
        {"dilation", "dilation by a tip of 41 x 41 pixels", dilation},
    };
    return list;
}

}  // namespace setae::benchmarks
