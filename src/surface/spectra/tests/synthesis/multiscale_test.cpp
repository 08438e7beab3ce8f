// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/multiscale.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/nonuniform.hpp"
#include "synthesis/periodic_patch.hpp"

namespace multiscale_test {

using namespace setae;
using namespace setae::synthesis;
using Complex = std::complex<double>;

TEST(PeriodicPatch, IsTheSumOfItsModesAnywhere) {
    const auto modes = [](Index k, Index m) {
        return std::polar(std::abs(k) + std::abs(m) > 40 ? 1.0 : 0.0,
                          0.7 * static_cast<double>(k * k) - 1.3 * static_cast<double>(m * m + k));
    };
    const PeriodicPatch patch(modes);
    // on the grid, between, at both ends, outside the period
    const double u[] = {0.0, 0.3, 511.7 / 512.0, 1.0 - 1e-17, -0.2, 7.123, 0.5},
                 v[] = {0.0, 0.9999, 1e-9, 0.4, 3.7, -5.55, 0.001};
    double sums[7] = {}, power = 0.0, expected[7] = {};
    patch.add_at(u, v, sums, 7);
    for (Index k = 0; k <= 128; ++k)
        for (Index m = k == 0 ? 1 : -128; m <= 128; ++m) {
            const Complex mode = modes(k, m);
            power += 2.0 * std::norm(mode);
            for (int i = 0; i < 7; ++i)
                expected[i] +=
                    2.0 *
                    (mode * std::polar(1.0, 2.0 * pi * (static_cast<double>(k) * u[i] + static_cast<double>(m) * v[i])))
                        .real();
        }
    for (int i = 0; i < 7; ++i) EXPECT_LT(std::abs(sums[i] - expected[i]), 1e-6 * std::sqrt(power)) << i;
}

// seven decades of wavelengths: 0.4 nm to 4 mm, roll-off at 2 µm
const spectra::SelfAffine model{1e-28, 2.0 * pi / 2e-6, 0.8, 2.0 * pi / 4e-10};

const MultiscaleSurface& surface() {
    static const MultiscaleSurface made(spectra::density(model), {{11, 0}, 4e-3, 4e-10, {1}});
    return made;
}

TEST(MultiscaleSurface, HasTheMomentsOfItsSpectrum) {
    // cells of the modes cut by q_s count with their share, to about 1e-4 of the power
    EXPECT_NEAR(surface().rms_height() / spectra::rms_height(model), 1.0, 1e-4);
    EXPECT_NEAR(surface().rms_slope() / spectra::rms_slope(model), 1.0, 1e-3);
}

TEST(MultiscaleSurface, IsTheSameInWindowsOfAnySizeAndPixel) {
    const double x = 2.5e-3, y = -1.7e-3;
    const auto coarse = surface().window({x, y, 5, 4, 1e-6}),
               fine = surface().window({x + 2e-6, y + 1e-6, 30, 20, 1e-7});
    const auto finest = surface().window({x + 2e-6 + 1e-7, y + 1e-6, 12, 3, 1e-9});
    const double rounding = 1e-7 * spectra::rms_height(model);  // positions of millimetres, wavelengths of 0.4 nm
    EXPECT_NEAR(coarse.heights(2, 1), fine.heights(0, 0), rounding);
    EXPECT_NEAR(coarse.heights(4, 2), fine.heights(20, 10), rounding);
    EXPECT_NEAR(fine.heights(1, 0), finest.heights(0, 0), rounding);
    const auto line = surface().line({x, y, 0.5 * pi, 4, 1e-6});
    EXPECT_NEAR(line.heights[3], coarse.heights(0, 3), rounding);
    EXPECT_NEAR(surface().heights_at(Array1D::Constant(1, x + 4e-6), Array1D::Constant(1, y + 2e-6))[0],
                coarse.heights(4, 2), rounding);
}

TEST(MultiscaleSurface, HasTheSameBytesForAnyNumberOfThreads) {
    const MultiscaleOptions options{{4, 4}, 1e-6, 2e-9, {3}};
    auto single = options;
    single.threads = {1};
    const Window window{1e-5, 2e-5, 60, 40, 3e-9};
    EXPECT_TRUE((MultiscaleSurface(spectra::density(model), options).window(window).heights ==
                 MultiscaleSurface(spectra::density(model), single).window(window).heights)
                    .all());
}

TEST(MultiscaleSurface, KeepsLongWavesWhenShortWavesAreOmitted) {
    const MultiscaleSurface blurred(spectra::density(model), {{11, 0}, 4e-3, 1e-8, {1}});
    const Array1D x = Array1D::LinSpaced(400, 0.0, 2e-6), y = Array1D::Constant(400, 3e-4);
    const double left_out = std::sqrt((surface().heights_at(x, y) - blurred.heights_at(x, y)).square().mean());
    const double expected =
        std::sqrt(spectra::moment(model, 0.0) / (2.0 * pi) - blurred.rms_height() * blurred.rms_height());
    EXPECT_NEAR(left_out / expected, 1.0, 0.2);  // about 100 independent values of ± 7 % in each direction
}

/// Variance of the increments of a line with the model's spectrum: ⟨(h(x + d) − h(x))²⟩ = (1/π) ∫ q C (1 − J_0(qd)) dq.
double increment_variance(double distance) {
    constexpr int pieces = 40000;
    const double from = std::log(2.0 * pi / 4e-3), to = std::log(model.short_wavevector);
    const auto C = spectra::density(model);
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double q = std::exp(from + (to - from) * (i + 0.5) / pieces);
        sum += q * q * C(q) * (1.0 - std::cyl_bessel_j(0.0, std::min(q * distance, 1e6))) * (to - from) / pieces;
    }
    return sum / pi;
}

TEST(MultiscaleSurface, HasTheStructureFunctionOfItsSpectrumOverAllScales) {
    constexpr Index n = 4000;
    for (const double distance : {1e-9, 2e-8, 4e-7}) {
        // pairs far apart, so independent: standard error √(2/n) = 2.2 % of the variance
        const Array1D x = Array1D::LinSpaced(n, 0.0, 0.03), y = 0.37 * x;
        const double measured = (surface().heights_at(x + distance, y) - surface().heights_at(x, y)).square().mean();
        EXPECT_NEAR(measured / increment_variance(distance), 1.0, 0.08) << distance;
    }
}

TEST(MultiscaleSurface, HasAliasesForCoarsePixels) {
    // steps of 20 roll-off wavelengths have independent heights: a white spectrum of the whole variance
    constexpr Index n = 4096;
    const auto line = surface().line({0.0, 0.0, 0.3, n, 4e-5});
    const double variance = line.heights.square().mean();
    EXPECT_NEAR(variance / (spectra::rms_height(model) * spectra::rms_height(model)), 1.0, 4.0 * std::sqrt(2.0 / n));
    for (const Index lag : {1, 2, 5, 100})
        EXPECT_LT(std::abs((line.heights.head(n - lag) * line.heights.tail(n - lag)).mean()) / variance,
                  4.0 / std::sqrt(static_cast<double>(n - lag)))
            << lag;
}

TEST(MultiscaleSurface, RefusesInvalidWavelengthsAndWindows) {
    const auto C = spectra::density(model);
    EXPECT_THROW(MultiscaleSurface(C, {{}, 1e-9, 1e-6}), InvalidArgument);
    EXPECT_THROW(MultiscaleSurface(C, {{}, 1e-6, 0.0}), InvalidArgument);
    EXPECT_THROW(MultiscaleSurface(C, {{}, 1e-10, 1e-11}), InvalidArgument);  // all shorter than the cutoff
    EXPECT_THROW(MultiscaleSurface([](double) { return -1.0; }, {{}, 1e-6, 1e-8}), InvalidArgument);
    EXPECT_THROW((void)surface().window({0.0, 0.0, 0, 4, 1e-9}), InvalidArgument);
    EXPECT_THROW((void)surface().line({0.0, 0.0, 0.0, 4, 0.0}), InvalidArgument);
    EXPECT_THROW((void)surface().heights_at(Array1D::Zero(2), Array1D::Zero(3)), InvalidArgument);
}

}  // namespace multiscale_test
