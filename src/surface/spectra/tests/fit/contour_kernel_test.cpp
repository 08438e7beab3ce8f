// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit/contour_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/trace_response.hpp"

namespace contour_kernel_test {

using namespace setae;
using namespace setae::spectral_fit;

/// q_s e^{h(i − N)}.
Array1D nodes_up_to(double shortest, Index count) {
    return shortest * (Array1D::LinSpaced(count, static_cast<double>(1 - count), 0.0) * node_spacing).exp();
}

TEST(ContourKernel, PredictsTheMeanPeriodogramOfRandomCurves) {
    // one set of irregular points, many curves: mean step 1, waves down to wavelength 2
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> step(0.3, 1.7);
    std::normal_distribution<double> normal;
    topography::Profile contour{Array1D(120), Array1D(120), {}};
    double x = 0.0;
    for (Index i = 0; i < 120; ++i, x += step(random)) contour.positions[i] = x;
    const spectra::SelfAffine model{1.0, 0.08, 0.8, pi};
    const double size = 16.0 * x;
    const Index modes = static_cast<Index>(model.short_wavevector * size / (2.0 * pi));
    const Array1D q = Array1D::LinSpaced(modes, 1.0, static_cast<double>(modes)) * (2.0 * pi / size);
    const Array1D amplitude = (2.0 * spectra::profile_power_spectrum(model, q) / size).sqrt();
    Eigen::MatrixXd cosines(120, modes), sines(120, modes);
    for (Index k = 0; k < modes; ++k) {
        cosines.col(k) = ((contour.positions * q[k]).cos() * amplitude[k]).matrix();
        sines.col(k) = ((contour.positions * q[k]).sin() * amplitude[k]).matrix();
    }
    const Array1D nodes = nodes_up_to(pi, 150);
    // the operator does not depend on the heights, so one kernel applies to all curves: only the periodogram is
    // computed again
    constexpr int curves = 400;
    Array1D mean;
    std::vector<Array1D> periodograms;
    for (int curve = 0; curve < curves; ++curve) {
        const Eigen::VectorXd a = Eigen::VectorXd::NullaryExpr(modes, [&] { return normal(random); });
        const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(modes, [&] { return normal(random); });
        contour.heights = (cosines * a + sines * b).array();
        const Array1D periodogram = contour_periodogram(contour);
        mean = curve == 0 ? periodogram : Array1D(mean + periodogram);
        periodograms.push_back(periodogram);
    }
    mean /= curves;
    const auto kernel = contour_kernel(contour, nodes);
    const Array1D expected =
        (kernel.response.matrix() * spectra::isotropic_power_spectrum(model, nodes).matrix()).array();
    const Array1D ratio = mean / expected;
    for (Index k = 0; k < ratio.size(); ++k)
        EXPECT_NEAR(ratio[k], 1.0, 4.5 / std::sqrt(double(curves))) << "group " << k;
    EXPECT_NEAR(ratio.mean(), 1.0, 3.0 * 0.05 / std::sqrt(0.5 * static_cast<double>(ratio.size())));
    // Var Σ_k P_k/E_k = Σ_kk' |ρ_kk'|² = Σ_k 1/ω_k, with an error of √(2/400) = 7 % from this number of curves
    const Array1D share = independent_share(contour, nodes, spectra::isotropic_power_spectrum(model, nodes));
    const Array1D counts =
        Array1D::NullaryExpr(share.size(), [&](Index b) { return static_cast<double>(kernel.bins.count(b)); });
    double sum = 0.0, squares = 0.0;
    for (const auto& periodogram : periodograms) {
        const double s = (counts * periodogram / expected).sum();
        sum += s / curves;
        squares += s * s / curves;
    }
    EXPECT_NEAR((squares - sum * sum) / (counts / share).sum(), 1.0, 0.25);
    EXPECT_LT(share.tail(3).maxCoeff(), 0.45);  // irregular steps scatter power at the end of the band
}

TEST(ContourKernel, PredictsNoiseAndSmoothingOfATrace) {
    // irregular points with different errors, noise smoothed from point to point, curve and noise of similar power at
    // the end
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> step(0.6, 1.4);
    constexpr Index points = 100;
    topography::Profile contour{Array1D(points), Array1D(points), {}};
    double x = 0.0;
    for (Index i = 0; i < points; ++i, x += step(random)) contour.positions[i] = x;
    const Array1D count = Array1D::LinSpaced(points, 0.0, points - 1.0);
    contour.standard_error = 0.1 * (1.5 + (0.3 * count).sin());
    contour.response = topography::TraceResponse{0.5, 0.8, contour.size() / (points - 1.0), 0.01};
    // long waves of the noise have C1D 0.01: Σ a² d² = 0.01 L
    Array1D share(points);
    for (Index i = 0; i < points; ++i)
        share[i] = 0.5 * (contour.positions[std::min<Index>(i + 1, points - 1)] -
                          contour.positions[std::max<Index>(i - 1, 0)]);
    const Array1D deviation =
        contour.standard_error * std::sqrt(0.01 * contour.size() / (contour.standard_error * share).square().sum());

    const spectra::SelfAffine model{1.0, 0.08, 0.8, pi};
    const auto& response = *contour.response;
    const Array1D table_q = Array1D::LinSpaced(300, 1e-3, pi);
    const auto curve_density =
        spectra::tabulated_density(table_q, spectra::profile_power_spectrum(model, table_q) *
                                                topography::trace_transfer(response, table_q).square());
    const auto noise_density = [&](double angle) {
        return std::pow(topography::smoothing_transfer(response, Array1D::Constant(1, angle / response.step))[0], 2);
    };
    constexpr int curves = 200, fine = 16;
    const Index grid = 2 * points * fine;
    Array1D mean;
    for (int curve = 0; curve < curves; ++curve) {
        const synthesis::SurfaceOptions one{.key = {static_cast<std::uint64_t>(curve), 1}},
            other{.key = {static_cast<std::uint64_t>(curve), 2}};
        const auto surface = synthesis::random_line(curve_density, {grid, 2.0 * points}, one);
        const auto noise = synthesis::random_line(noise_density, {2 * points, 2.0 * points}, other);
        for (Index i = 0; i < points; ++i)
            contour.heights[i] =
                surface.heights[std::lround(fine * contour.positions[i])] + deviation[i] * noise.heights[i];
        const auto periodogram = contour_periodogram(contour);
        mean = curve == 0 ? periodogram : Array1D(mean + periodogram);
    }
    mean /= curves;
    const Array1D nodes = nodes_up_to(pi, 150);
    const auto kernel = contour_kernel(contour, nodes);
    ASSERT_EQ(kernel.noise.size(), mean.size());
    const Array1D expected =
        (kernel.response.matrix() * spectra::isotropic_power_spectrum(model, nodes).matrix()).array() + kernel.noise;
    EXPECT_GT((kernel.noise / expected).maxCoeff(), 0.4);
    const Array1D ratio = mean / expected;
    for (Index k = 0; k < ratio.size(); ++k)
        EXPECT_NEAR(ratio[k], 1.0, 4.5 / std::sqrt(double(curves))) << "group " << k;
    EXPECT_NEAR(ratio.mean(), 1.0, 3.0 * 0.07 / std::sqrt(0.5 * static_cast<double>(ratio.size())));
}

TEST(ContourKernel, WithoutNoiseBlurAndSmoothingEqualsThatOfThePoints) {
    topography::Profile contour{Array1D::LinSpaced(60, 0.0, 59.0), Array1D::LinSpaced(60, 0.0, 5.0).sin(), {}};
    const Array1D nodes = nodes_up_to(pi, 100);
    const auto plain = contour_kernel(contour, nodes);
    EXPECT_EQ(plain.noise.size(), 0);
    contour.response = topography::TraceResponse{0.0, 0.0, 1.0, 0.0};
    const auto ideal = contour_kernel(contour, nodes);
    EXPECT_TRUE((ideal.response == plain.response).all());
    EXPECT_EQ(ideal.noise.maxCoeff(), 0.0);
}

TEST(ContourKernel, OfWhiteNoiseOnEqualStepsIsTheNoiseDensity) {
    topography::Profile contour{Array1D::LinSpaced(201, 0.0, 100.0), Array1D::Zero(201), {}};
    contour.response = topography::TraceResponse{0.0, 0.0, 0.5, 2e-3};
    const auto kernel = contour_kernel(contour, nodes_up_to(2.0 * pi, 100));
    // below half of Nyquist the spline passes all of it; the first modes lose the subtracted line
    for (const Index b : {6, 8, 10}) EXPECT_NEAR(kernel.noise[b] / 2e-3, 1.0, 0.02) << b;
}

TEST(IndependentShare, OfEqualStepsEqualsThatOfTheWindow) {
    const topography::Profile contour{Array1D::LinSpaced(201, 0.0, 200.0), Array1D::Zero(201), {}};
    const Array1D nodes = nodes_up_to(1.0, 120);
    const Array1D share = independent_share(contour, nodes, nodes.pow(-2.0));
    for (const Index b : {8, 12, 20}) EXPECT_NEAR(share[b], 1.0 / (1.0 + 2.0 * (4.0 / 9.0 + 1.0 / 36.0)), 0.02) << b;
}

TEST(ContourKernel, OfEqualStepsKeepsAWaveInItsMode) {
    // equal steps, a wave of a quarter of the band: its power returns at its own mode
    topography::Profile contour{Array1D::LinSpaced(401, 0.0, 400.0), Array1D::Zero(401), {}};
    const double q = 2.0 * pi * 50.0 / 400.0;
    contour.heights = (contour.positions * q).cos();
    const auto periodogram = contour_periodogram(contour);
    const ModeBins bins(200);
    double sum = 0.0;
    for (Index b = 0; b < bins.size(); ++b) sum += static_cast<double>(bins.count(b)) * periodogram[b];
    EXPECT_NEAR(2.0 * sum / 400.0, 0.5, 0.01);  // (2/L) Σ P = ⟨h²⟩
}

TEST(ContourKernel, RefusesContoursOfFewOrUndefinedPoints) {
    const Array1D nodes = nodes_up_to(1.0, 20);
    EXPECT_THROW((void)contour_kernel({Array1D::LinSpaced(5, 0.0, 1.0), Array1D::Zero(5), {}}, nodes), InvalidArgument);
    topography::Profile holed{Array1D::LinSpaced(20, 0.0, 1.0), Array1D::Zero(20), {}};
    holed.heights[3] = undefined;
    EXPECT_THROW((void)contour_kernel(holed, nodes), UndefinedDataError);
}

}  // namespace contour_kernel_test
