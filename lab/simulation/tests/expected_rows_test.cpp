// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/spectral_fit/scan_kernel.hpp"
#include "surfaces/surface_patches.hpp"

namespace setae::simulation::expected_rows_test {
namespace {

constexpr double length = 1e-6;

/// Self-affine; the cutoff stands on a node of the kernel's grid, far beyond the sampling.
spectra::SelfAffine model_with(double rolloff, double step) {
    const double upper =
        std::exp(std::ceil(std::log(30.0) / spectral_fit::node_spacing) * spectral_fit::node_spacing) / step;
    return {1e-30, 2.0 * pi / rolloff, 0.8, upper};
}

KnownSurface surface_of(const spectra::SelfAffine& model) {
    return {.C_iso = spectra::density(model),
            .rolloff_wavelength = 2.0 * pi / model.rolloff_wavevector,
            .short_wavelength = 2.0 * pi / model.short_wavevector};
}

/// What a detrended, windowed line of points expects of the surface, aliases and all; made without drawing anything.
Array1D expected(const spectra::SelfAffine& model, const spectral_fit::ScanShape& shape, double step) {
    const auto first =
        static_cast<Index>(std::floor(std::log(1e-4 / static_cast<double>(shape.points)) / spectral_fit::node_spacing));
    const auto last =
        static_cast<Index>(std::ceil(std::log(model.short_wavevector * step) / spectral_fit::node_spacing));
    const auto kernel = spectral_fit::scan_kernel(shape, first, last);
    const Array1D q = (Array1D::LinSpaced(last - first + 1, static_cast<double>(first), static_cast<double>(last)) *
                       spectral_fit::node_spacing)
                          .exp() /
                      step;
    const Array1D C_iso = spectra::isotropic_power_spectrum(model, q);
    return ((kernel.response.matrix() * C_iso.matrix()).array() + kernel.flat_response * C_iso[0]) / step;
}

TEST(MapRows, HaveTheExpectedPeriodogramWithARolloffBeyondTheMap) {
    const Index pixels = 32;
    const double step = length / static_cast<double>(pixels);
    const auto model = model_with(4.0 * length, step);
    const AfmProtocol protocol{.sizes = {length}, .pixels = {pixels}, .tip_radius = 0.0};
    const Array1D mean = expected(model, {pixels, 1}, step);
    Array1D sum = Array1D::Zero(mean.size());
    constexpr int maps = 30;
    for (std::uint64_t seed = 0; seed < maps; ++seed)
        sum += spectral_fit::scan_periodogram(afm_scan(surface_of(model), protocol, 0, {seed, 2}).heights, step, 1);
    // rows of a map are alike in their first modes: 0.6, 0.5, 0.4, 0.3 of the mean a map (from 1000 of them), less then
    for (Index k = 0; k < mean.size(); ++k) {
        const double scatter = std::max(0.6 - 0.1 * static_cast<double>(k), 0.2);
        EXPECT_NEAR(sum[k] / maps / mean[k], 1.0, 3.0 * scatter / std::sqrt(maps)) << k;
    }
}

TEST(ScansWithoutTip, HaveTheExpectedPeriodogramWithARolloffBeyondTheScan) {
    const Index points = 128;
    const double step = length / static_cast<double>(points);
    for (const double rolloff : {0.1 * length, 50.0 * length}) {
        const auto model = model_with(rolloff, step);
        constexpr int scans = 400;
        const StylusProtocol protocol{
            .lengths = std::vector<double>(scans, length), .steps = {step}, .tip_radius = 0.0};
        const Array1D mean = expected(model, {points, 2}, step);
        Array1D sum = Array1D::Zero(mean.size());
        for (const auto& scan : stylus_scans(surface_of(model), LineSpectrum(surface_of(model)), protocol, {4, 2}))
            sum += spectral_fit::scan_periodogram(scan.heights, step, 2);
        // a mode is exponentially distributed: 5 %; the first, of what the parabola leaves, a little more widely
        for (Index k = 0; k < mean.size(); ++k)
            EXPECT_NEAR(sum[k] / scans / mean[k], 1.0, 3.5 * 0.055) << rolloff << ", " << k;
    }
}

}  // namespace
}  // namespace setae::simulation::expected_rows_test
