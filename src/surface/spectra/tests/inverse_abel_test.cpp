// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/inverse_abel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::spectra::inverse_abel_test {
namespace {

Array1D decades(double from, double to, Index per_decade) {
    const auto count = static_cast<Index>(std::round(static_cast<double>(per_decade) * std::log10(to / from))) + 1;
    return (Array1D::LinSpaced(count, std::log(from), std::log(to))).exp();
}

TEST(InverseAbel, OfAPowerLawMatchesTheClosedForm) {
    for (const double alpha : {0.5, 1.0, 2.6, 5.0}) {
        const Array1D q = decades(1.0, 100.0, 10), C1D = q.pow(-alpha);
        const auto result = isotropic_from_lines(q, C1D);
        const double ratio = 2.0 / std::sqrt(pi) * std::tgamma(0.5 * (alpha + 1.0)) / std::tgamma(0.5 * alpha);
        for (Index k = 0; k < q.size(); ++k) {
            EXPECT_NEAR(result.ratio[k], ratio, 1e-9 * ratio);
            EXPECT_NEAR(result.density[k], pi * C1D[k] / q[k] * ratio, 1e-9 * result.density[k]);
        }
    }
}

TEST(InverseAbel, OfAGaussianAutocorrelationMatchesTheClosedForm) {
    // C1D = √π l h² exp(−q²l²/4), C_iso = π l² h² exp(−q²l²/4)
    const double length = 2e-6, height = 3e-9;
    const Array1D q = decades(1e5, 5e6, 40), fall = (-(q * length).square() / 4.0).exp();
    const auto result = isotropic_from_lines(q, std::sqrt(pi) * length * height * height * fall);
    const Array1D exact = pi * length * length * height * height * fall;
    for (Index k = 0; k < q.size(); ++k)
        EXPECT_NEAR(result.density[k] / exact[k], 1.0, q[k] < 4e6 ? 1e-3 : 0.1) << q[k];
}

TEST(InverseAbel, OfASelfAffineSurfaceRecoversItsSpectrum) {
    const spectra::SelfAffine model{1e-26, 1e6, 0.8, 1e13};
    const Array1D q = decades(1e5, 1e9, 20);
    const auto result = isotropic_from_lines(q, spectra::profile_power_spectrum(model, q));
    const Array1D exact = spectra::isotropic_power_spectrum(model, q);
    for (Index k = 0; k < q.size(); ++k) {
        const bool bend = std::abs(std::log10(q[k] / 1e6)) < 0.16;  // C_iso bends there within one interval
        EXPECT_NEAR(result.density[k] / exact[k], 1.0, bend ? 0.12 : 0.01) << q[k];
    }
    // the approximation π C1D/q misses the plateau: C1D no longer rises there towards q = 0 and C_iso q/π is below it
    EXPECT_LT(result.ratio[0], 0.2);
    EXPECT_NEAR(result.ratio[60], 2.0 / std::sqrt(pi) * std::tgamma(1.8) / std::tgamma(1.3), 0.01);
}

TEST(InverseAbel, InvertsTheAbelIntegral) {
    // any curve: a bump on a power law
    const Array1D nodes = decades(1e4, 1e9, 40);
    const Array1D C_iso =
        1e-26 * (1.0 + (nodes / 1e6).square()).pow(-1.7) * (1.0 + 2.0 * (-((nodes / 1e7).log() / 0.8).square()).exp());
    const Array1D q = decades(2e4, 2e7, 20);
    const auto result = isotropic_from_lines(q, spectra::profile_from_isotropic(nodes, C_iso, q));
    for (Index k = 0; k < q.size(); ++k) {
        if (q[k] > 1e7) continue;  // the last third of a decade depends on the power law beyond
        const double place = std::log(q[k] / nodes[0]) / std::log(nodes[1] / nodes[0]);
        const auto node = static_cast<Index>(place);
        const double exact = std::exp(std::log(C_iso[node]) +
                                      (place - static_cast<double>(node)) * std::log(C_iso[node + 1] / C_iso[node]));
        EXPECT_NEAR(result.density[k] / exact, 1.0, 0.01) << q[k];
    }
}

TEST(InverseAbel, StandardErrorsMatchTheScatter) {
    const spectra::SelfAffine model{1e-26, 1e6, 0.8, 1e13};
    const Array1D q = decades(1e6, 1e9, 10),
                  C1D = spectra::profile_power_spectrum(model, q);  // where C1D is constant it contains little
                                                                    // information on C_iso
    const Index n = q.size();
    constexpr int trials = 300;
    const double relative = 0.08;
    Array1D sum = Array1D::Zero(n), squares = Array1D::Zero(n), stated = Array1D::Zero(n);
    for (int t = 0; t < trials; ++t) {
        const Array1D noisy =
            C1D * (1.0 + relative * numerics::normal_numbers({5, static_cast<std::uint64_t>(t)}, 0, n));
        const auto result = isotropic_from_lines(q, noisy, relative * noisy, {.smoothing = 0.6});
        ASSERT_FALSE(result.density.isNaN().any());
        sum += result.density / trials;
        squares += result.density.square() / trials;
        stated += result.standard_error / trials;
    }
    const Array1D scatter = (squares - sum.square()).sqrt(), exact = spectra::isotropic_power_spectrum(model, q);
    for (Index k = 0; k < n; ++k) {
        EXPECT_NEAR(stated[k] / scatter[k], 1.0, 0.2) << q[k];
        if (q[k] > 2.5e6 && q[k] < 4e8) {
            EXPECT_NEAR(sum[k] / exact[k], 1.0, 0.06) << q[k];
        }
    }
}

TEST(InverseAbel, SmoothsSpectraWithBinsOfOneMeasurement) {
    const spectra::SelfAffine model{1e-26, 1e6, 0.8, 1e13};
    CombinedSpectrum spectrum;
    spectrum.wavevector = decades(1e5, 1e9, 10);
    spectrum.density = spectra::profile_power_spectrum(model, spectrum.wavevector);
    spectrum.count = Array1D::Constant(spectrum.density.size(), 3.0);
    spectrum.standard_error = 0.1 * spectrum.density;
    spectrum.standard_error[5] = undefined;
    spectrum.count[5] = 1.0;
    const auto result = isotropic_from_lines(spectrum);
    EXPECT_FALSE(result.standard_error.isNaN().any());
    spectrum.standard_error.setConstant(undefined);
    const auto unknown = isotropic_from_lines(spectrum);
    EXPECT_FALSE(unknown.density.isNaN().any());
    EXPECT_TRUE(unknown.standard_error.isNaN().all());
}

TEST(InverseAbel, IsUndefinedWhereC1DRises) {
    const Array1D q = decades(1.0, 10.0, 10);
    const auto result = isotropic_from_lines(q, q);
    EXPECT_TRUE(result.density.isNaN().all());
}

TEST(InverseAbel, RefusesInvalidSpectra) {
    const Array1D q = decades(1.0, 10.0, 10);
    EXPECT_THROW((void)isotropic_from_lines(q.head(3), q.head(3)), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_lines(q, -q), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_lines(q.reverse().eval(), q), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_lines(q, q, q.head(4)), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_lines(q, q, q, {.smoothing = -1.0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::spectra::inverse_abel_test
