// SPDX-License-Identifier: GPL-3.0-or-later
// Processing of heights by a pipeline before the fit.
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "setae/core/constants.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectral_fit::removed_waves_test {
namespace {

constexpr Index points = 1024;
constexpr double step = 50e-9, rolloff = 2.0 * pi / 40e-6;

double C1D(double q) { return 1e-21 * std::pow(1.0 + q * q / (rolloff * rolloff), -1.3); }

topography::LineScan line(std::uint64_t seed) {
    const auto whole = synthesis::random_line(C1D, {4 * points, 4 * points * step}, {.key = {seed, 0}, .threads = {1}});
    topography::LineScan scan{whole.heights.head(points), points * step, false, {}};
    scan.metadata.instrument.type = "stylus";
    return scan;
}

void remove_polynomial(topography::LineScan& scan, int degree) {
    Eigen::MatrixXd powers(points, degree + 1);
    for (int d = 0; d <= degree; ++d) powers.col(d) = Array1D::LinSpaced(points, -1.0, 1.0).pow(d).matrix();
    const Eigen::VectorXd heights = scan.heights.matrix();
    scan.heights = (heights - powers * powers.colPivHouseholderQr().solve(heights)).array();
}

/// Removes waves longer than 5 µm, with a sharp limit.
void remove_long_waves(topography::LineScan& scan) {
    for (Index k = 0; k < 11; ++k) {
        const Array1D phase = Array1D::LinSpaced(points, 0.0, static_cast<double>(points - 1)) *
                              (2.0 * pi * static_cast<double>(k) / static_cast<double>(points));
        const double c = (scan.heights * phase.cos()).mean(), s = (scan.heights * phase.sin()).mean();
        scan.heights -= (k > 0 ? 2.0 : 1.0) * (c * phase.cos() + s * phase.sin());
    }
}

/// Σ ln of C_iso over the true value, over the nodes between two wavevectors.
double long_waves(const LikelihoodSpectrum& fit, double from, double to) {
    double found = 0.0, true_sum = 0.0;
    const auto& q = fit.C_iso.wavevector;
    for (Index i = 0; i < q.size(); ++i) {
        if (q[i] < from || q[i] > to) continue;
        // C_iso of this C1D ∝ (1 + x²)^−1.3 is (2/√π) Γ(1.8)/Γ(1.3) π C1D(q)/√(q² + q_r²)
        const double C =
            2.0 / std::sqrt(pi) * std::tgamma(1.8) / std::tgamma(1.3) * pi * C1D(q[i]) / std::hypot(q[i], rolloff);
        found += std::log(fit.C_iso.density[i]);
        true_sum += std::log(C);
    }
    return found - true_sum;
}

int nodes(const LikelihoodSpectrum& fit, double from, double to) {
    return static_cast<int>((fit.C_iso.wavevector >= from && fit.C_iso.wavevector <= to).count());
}

LikelihoodSpectrum fitted(const std::vector<ObservedSurface>& observed) {
    return likelihood_spectrum(observed, {.shortest_wavelength = 2.0 * step, .threads = {1}});
}

TEST(RemovedWaves, OfAPolynomialAreCorrectedByTheFit) {
    std::vector<ObservedSurface> with_data, without_data;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        auto scan = line(seed);
        remove_polynomial(scan, 7);
        with_data.push_back({scan, topography::Trend::none, 7});
        without_data.push_back({scan, topography::Trend::none});
    }
    const double from = 2.0 * pi / 25e-6, to = 2.0 * pi / 12e-6;
    const auto right = fitted(with_data), wrong = fitted(without_data);
    EXPECT_LT(std::abs(long_waves(right, from, to) / nodes(right, from, to)), 0.12);
    EXPECT_LT(long_waves(wrong, from, to) / nodes(wrong, from, to), -0.4);
}

TEST(RemovedWaves, OfAFilterAreExcludedFromTheFit) {
    std::vector<ObservedSurface> with_data, without_data;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        auto scan = line(seed);
        remove_long_waves(scan);
        with_data.push_back({scan, topography::Trend::none, 0, {2.0 * pi / 3.6e-6, 1e12}});
        without_data.push_back({scan, topography::Trend::none});
    }
    const double from = 2.0 * pi / 3.5e-6, to = 2.0 * pi / 2e-6, cut = 2.0 * pi / 5e-6;
    const auto right = fitted(with_data), wrong = fitted(without_data);
    EXPECT_GT(right.C_iso.band.lower, 2.0 * pi / 3.7e-6);
    EXPECT_LT(std::abs(long_waves(right, from, to) / nodes(right, from, to)), 0.12);
    // without this information the fit bends to the missing waves
    EXPECT_LT(long_waves(wrong, cut, from) / nodes(wrong, cut, from), -0.3);
}

}  // namespace
}  // namespace setae::spectral_fit::removed_waves_test
