// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/abel.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"

namespace abel_test {

using namespace setae;
using namespace setae::spectra;
using tests::log_spaced;

TEST(ProfileFromIsotropic, OfAPlateauIsASemicircle) {
    const Array1D nodes{{1.0, 10.0}}, level = Array1D::Constant(2, 3.0);
    const Array1D q{{0.0, 0.5, 1.0, 2.0, 9.9, 10.0, 11.0}};
    const auto profile = profile_from_isotropic(nodes, level, q);
    for (Index k = 0; k < q.size(); ++k)
        EXPECT_NEAR(profile[k], q[k] < 10.0 ? 3.0 / pi * std::sqrt(100.0 - q[k] * q[k]) : 0.0, 1e-10 * 10.0) << q[k];
}

TEST(ProfileFromIsotropic, OfAnInverseFourthPowerMatchesTheClosedForm) {
    // ∫ v-substitution: C = q^-4 gives (1/π) ∫_0^V dv/(q_x²+v²)² = [v/(2q²(q²+v²)) + atan(v/q)/(2q³)]/π
    const Array1D nodes{{0.01, 100.0}};
    const Array1D q = log_spaced(40, 0.01, 99.0);
    const auto profile = profile_from_isotropic(nodes, nodes.pow(-4.0), q);
    for (Index k = 0; k < q.size(); ++k) {
        const double x = q[k], v = std::sqrt(1e4 - x * x);
        const double exact = (v / (2.0 * x * x * 1e4) + std::atan(v / x) / (2.0 * x * x * x)) / pi;
        EXPECT_NEAR(profile[k] / exact, 1.0, 1e-10) << x;
    }
}

TEST(ProfileFromIsotropic, OfAGaussianIsAGaussian) {
    // power laws between nodes a ratio e^0.0022 apart have an error of 2.4e-6 q²
    const auto nodes = log_spaced(4000, 1e-3, 6.0);
    const Array1D q = log_spaced(30, 1e-3, 2.0);
    const auto profile = profile_from_isotropic(nodes, (-nodes.square()).exp(), q);
    EXPECT_LT((profile / ((-q.square()).exp() / (2.0 * std::sqrt(pi))) - 1.0).abs().maxCoeff(), 1e-5);
}

TEST(IsotropicFromProfile, InvertsTheAbelIntegral) {
    const SelfAffine model{2.0, 1.0, 0.7, 300.0};
    const auto q = log_spaced(60, 0.05, 299.0);
    const Array1D C_iso = isotropic_power_spectrum(model, q);
    Array1D nodes(61), values(61);
    nodes << q, 300.0;
    values << C_iso, isotropic_power_spectrum(model, Array1D::Constant(1, 300.0));
    const Array1D C1D = profile_from_isotropic(nodes, values, q);
    const auto back = isotropic_from_profile(q, C1D, 300.0, 200);
    EXPECT_LT((profile_from_isotropic(q, back, q).head(55) / profile_from_isotropic(q, C_iso, q).head(55) - 1.0)
                  .abs()
                  .maxCoeff(),
              0.02);
    EXPECT_LT((back / C_iso - 1.0).abs().head(55).maxCoeff(), 0.02);
    const auto eq11 = isotropic_from_profile(q, C1D, 300.0, 0);
    EXPECT_GT((eq11 / C_iso - 1.0).abs().head(55).maxCoeff(), 0.2);
}

TEST(IsotropicFromProfileEq11, MatchesTheFormula) {
    const Array1D q{{1.0, 6.0, 10.0, 12.0}}, C1D = Array1D::Constant(4, 2.0);
    const auto C_iso = isotropic_from_profile_eq11(q, C1D, 10.0);
    EXPECT_NEAR(C_iso[0], 2.0 * pi / std::sqrt(0.99), 1e-14);
    EXPECT_NEAR(C_iso[1], 2.0 * pi / 6.0 / 0.8, 1e-14);
    EXPECT_TRUE(std::isnan(C_iso[2]) && std::isnan(C_iso[3]));
    EXPECT_NEAR(isotropic_from_profile_eq11(q, C1D, std::numeric_limits<double>::infinity())[1], 2.0 * pi / 6.0, 1e-14);
}

TEST(Abel, RefusesInvalidCurves) {
    const Array1D two{{1.0, 2.0}}, falling{{2.0, 1.0}}, one = Array1D::Ones(1), negative{{1.0, -1.0}};
    EXPECT_THROW((void)profile_from_isotropic(one, one, one), InvalidArgument);
    EXPECT_THROW((void)profile_from_isotropic(falling, two, one), InvalidArgument);
    EXPECT_THROW((void)profile_from_isotropic(two, negative, one), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_profile_eq11(two, one, 1.0), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_profile(two, two, 2.0), InvalidArgument);
    EXPECT_THROW((void)isotropic_from_profile(two, two, 3.0, -1), InvalidArgument);
}

TEST(SelfAffine, MomentsOfTheProfileSpectrumEqualThoseOfTheSurface) {
    // ∫ q^(n+1) C_iso = π k_n ∫ q^n C1D, k_0 = 2/π, k_2 = 4/π, k_4 = 16/(3π)
    const SelfAffine model{1.0, 1.0, 0.8, 1000.0};
    const auto integral = [&](double order) {
        // midpoint rule in t, q = q_s sin t: smooth through the root of C1D at q_s
        constexpr Index n = 20000;
        const Array1D u = Array1D::LinSpaced(n, 0.5, n - 0.5) / static_cast<double>(n);
        const Array1D t = 0.5 * pi * u.pow(4);
        const Array1D q = 1000.0 * t.sin();
        const Array1D weight = 1000.0 * t.cos() * 2.0 * pi * u.cube() / static_cast<double>(n);
        return (weight * q.pow(order) * profile_power_spectrum(model, q)).sum();
    };
    EXPECT_NEAR(moment(model, 0.0) / (2.0 * integral(0.0)), 1.0, 1e-6);
    EXPECT_NEAR(moment(model, 2.0) / (4.0 * integral(2.0)), 1.0, 1e-6);
    EXPECT_NEAR(moment(model, 4.0) / (16.0 / 3.0 * integral(4.0)), 1.0, 1e-6);
}

TEST(SelfAffine, MomentIsContinuousAtTheLogarithmicCase) {
    const SelfAffine at{1.0, 1.0, 0.5, 100.0}, beside{1.0, 1.0, 0.5 + 1e-9, 100.0};
    EXPECT_NEAR(moment(at, 1.0), 1.0 / 3.0 + std::log(100.0), 1e-12);
    EXPECT_NEAR(moment(at, 1.0), moment(beside, 1.0), 1e-7);
}

TEST(SelfAffine, IsRecoveredFromItsMoments) {
    for (const double hurst : {0.3, 0.8, 0.97, 1.2})
        for (const double rolloff : {1e5, 3e7}) {
            const SelfAffine model{1e-30, rolloff, hurst, 1.6e10};
            const auto found =
                self_affine_with_moments(rms_height(model), rms_slope(model), rms_curvature(model), 1.6e10);
            EXPECT_NEAR(found.hurst_exponent, hurst, 1e-9);
            EXPECT_NEAR(found.rolloff_wavevector / rolloff, 1.0, 1e-8);
            EXPECT_NEAR(found.plateau / 1e-30, 1.0, 1e-8);
        }
}

TEST(SelfAffine, RefusesImpossibleModelsAndMoments) {
    const Array1D q = Array1D::Ones(1);
    EXPECT_THROW((void)isotropic_power_spectrum(SelfAffine{1.0, 2.0, 0.8, 1.0}, q), InvalidArgument);
    EXPECT_THROW((void)rms_height(SelfAffine{1.0, 1.0, 1.6, 2.0}), InvalidArgument);
    EXPECT_THROW((void)self_affine_with_moments(1.0, 1.0, 1e3, 1.0), InvalidArgument);
    EXPECT_THROW((void)self_affine_with_moments(0.0, 1.0, 1.0, 1.0), InvalidArgument);
}

}  // namespace abel_test
