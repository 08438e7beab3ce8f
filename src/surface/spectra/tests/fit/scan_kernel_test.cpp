// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/scan_kernel.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/hat_node.hpp"

namespace scan_kernel_test {

using namespace setae;
using namespace setae::spectral_fit;

/// E[P] of a self-affine surface by its own C_iso at the nodes.
Array1D expected(const spectra::SelfAffine& model, const ScanShape& shape, double step, Index first, Index last) {
    const auto kernel = scan_kernel(shape, first, last);
    const Array1D q =
        (Array1D::LinSpaced(last - first + 1, static_cast<double>(first), static_cast<double>(last)) * node_spacing)
            .exp() /
        step;
    const Array1D f = spectra::isotropic_power_spectrum(model, q);
    return ((kernel.response.matrix() * f.matrix()).array() + kernel.flat_response * f[0]) / step;
}

/// Lines along x through the periodic random profile of the model's C1D, much longer than the line itself.
Array2D lines_of(const spectra::SelfAffine& model, Index points, double step, Index lines, unsigned seed) {
    const Index length = 16 * points;
    const double size = step * static_cast<double>(length);
    const Index modes = static_cast<Index>(model.short_wavevector * size / (2.0 * pi));
    const Array1D q = Array1D::LinSpaced(modes, 1.0, static_cast<double>(modes)) * (2.0 * pi / size);
    const Array1D C1D = spectra::profile_power_spectrum(model, q);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Array2D result(points, lines);
    for (Index line = 0; line < lines; ++line) {
        Array1D heights = Array1D::Zero(points);
        for (Index k = 0; k < modes; ++k) {
            const double amplitude = std::sqrt(2.0 * C1D[k] / size), a = normal(random), b = normal(random);
            for (Index i = 0; i < points; ++i) {
                const double phase = q[k] * step * static_cast<double>(i);
                heights[i] += amplitude * (a * std::cos(phase) + b * std::sin(phase));
            }
        }
        result.col(line) = heights;
    }
    return result;
}

TEST(ScanKernel, PredictsTheMeanPeriodogramOfRandomLines) {
    // roll-off inside the line, waves down to half a step: leakage, detrending and aliasing all matter
    const spectra::SelfAffine model{1.0, 0.15, 0.8, 4.0};
    for (const int degree : {1, 2}) {
        const ScanShape shape{64, degree};
        const auto heights = lines_of(model, shape.points, 1.0, 400, 5);
        const Array1D ratio = scan_periodogram(heights, 1.0, degree) / expected(model, shape, 1.0, -120, 24);
        // 400 lines: 5 % per mode, groups beyond the 16th contain several
        for (Index k = 0; k < ratio.size(); ++k)
            EXPECT_NEAR(ratio[k], 1.0, 4.5 * 0.05) << "degree " << degree << ", group " << k;
        EXPECT_NEAR(ratio.mean(), 1.0, 3.0 * 0.05 / std::sqrt(0.5 * static_cast<double>(ratio.size())));
    }
}

TEST(ScanKernel, DetrendingReducesTheFirstModes) {
    const spectra::SelfAffine steep{1.0, 1e-3, 0.8, 3.0};
    const auto mean = expected(steep, {256, 0}, 1.0, -140, 19), tilt = expected(steep, {256, 1}, 1.0, -140, 19),
               parabola = expected(steep, {256, 2}, 1.0, -140, 19);
    EXPECT_LT(tilt[0], 0.5 * mean[0]);
    EXPECT_LT(parabola[0], 0.5 * tilt[0]);
    EXPECT_NEAR(parabola[40] / mean[40], 1.0, 1e-3);
}

TEST(ScanKernel, OfAFlatSpectrumIsWhiteNoise) {
    // a disc of C_iso up to far beyond Nyquist has R(m) ≈ 0 at m > 0: the same shape as white noise
    const ScanShape shape{128, 2};
    const auto kernel = scan_kernel(shape, 160, 160);
    const double variance = std::exp(2.0 * 160 * node_spacing) * 0.5 / (2.0 * pi);
    EXPECT_LT((kernel.flat_response / variance / kernel.noise_response - 0.9424).abs().maxCoeff(), 0.06);
    EXPECT_NEAR(kernel.noise_response[30], 1.0, 0.01);
}

TEST(ScanKernel, SumOverModesIsTheVarianceOfTheWindowedHeights) {
    // Σ over all n modes of |F(wh)|²/n = Σ w²h²: for degree 0 and short waves the trend removes 1/n
    const ScanShape shape{512, 0};
    const auto kernel = scan_kernel(shape, 20, 20);
    const ModeBins bins(256);
    double sum = 0.0;
    for (Index b = 0; b < bins.size(); ++b) sum += 2.0 * static_cast<double>(bins.count(b)) * kernel.response(b, 0);
    EXPECT_NEAR(sum / 512.0, std::exp(40.0 * node_spacing) * node_spacing / (2.0 * pi), 0.02 * sum / 512.0);
}

TEST(ScanKernel, RefusesShapesWithoutModes) {
    EXPECT_THROW((void)scan_kernel({4, 1}, 0, 1), InvalidArgument);
    EXPECT_THROW((void)scan_kernel({64, 13}, 0, 1), InvalidArgument);
    EXPECT_THROW((void)scan_kernel({64, 1}, 3, 1), InvalidArgument);
    EXPECT_THROW((void)scan_periodogram(Array2D::Constant(64, 1, undefined), 1.0, 1), UndefinedDataError);
}

}  // namespace scan_kernel_test
