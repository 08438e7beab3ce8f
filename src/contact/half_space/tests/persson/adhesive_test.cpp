// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/adhesive.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "self_affine_curve.hpp"
#include "setae/core/errors.hpp"
#include "setae/persson/contact.hpp"
#include "setae/persson/stress_diffusion.hpp"

namespace setae::persson::adhesive_test {
namespace {

constexpr double modulus = 1e6;

Scales rough() { return scales_of(self_affine_curve(), {.contact_modulus = modulus}); }

double last(const Array1D& values) { return values[values.size() - 1]; }

// the solution of images against the diffusion solved step by step
TEST(StressDiffusion, UnderConstantDetachmentStressMatchesTheMirrorSolution) {
    const Array1D steps = Array1D::LinSpaced(200, -6.0, 2.0);
    Array1D variance(201);
    variance << 0.0, steps.unaryExpr([](double x) { return std::pow(10.0, x); });
    for (const double stress : {0.0, 0.7})
        for (const double pressure : {0.3, 1.0, 20.0}) {
            const auto solved = stress_diffusion(variance, Array1D::Constant(201, stress), pressure);
            for (Index i = 1; i < 201; ++i)
                EXPECT_NEAR(solved.area_fraction[i], area_fraction(pressure + stress, variance[i]), 1e-4) << i;
            for (Index j = 0; j < solved.pressure.size(); ++j) {
                const double width = std::sqrt(last(variance));
                EXPECT_NEAR(solved.density[j] * width,
                            width * pressure_density(solved.pressure[j] + stress, pressure + stress, last(variance)),
                            1e-4);
            }
        }
}

// σ_a that falls loses at once what it held: with p_0 far above, what is left is the mirror solution of the new one
TEST(StressDiffusion, DoesNotDependOnAnEarlierDetachmentStress) {
    const Array1D variance = Array1D::NullaryExpr(
        121, [](Index i) { return i == 0 ? 0.0 : std::pow(10.0, -4.0 + 0.05 * static_cast<double>(i)); });
    Array1D stress = Array1D::Constant(121, 2.0);
    for (Index i = 60; i < 121; ++i) stress[i] = 1.0;
    const auto held = stress_diffusion(variance, stress, 0.5),
               without = stress_diffusion(variance, Array1D::Ones(121), 0.5),
               with = stress_diffusion(variance, Array1D::Constant(121, 2.0), 0.5);
    EXPECT_LE(last(held.area_fraction), last(with.area_fraction));
    EXPECT_GE(last(held.area_fraction), last(without.area_fraction) * (1.0 - 1e-4));
    EXPECT_NEAR(held.area_fraction[59], with.area_fraction[59], 1e-12);
}

TEST(StressDiffusion, HasNoContactUnderTensionAboveTheDetachmentStress) {
    Array1D variance(3);
    variance << 0.0, 1.0, 2.0;
    EXPECT_EQ(last(stress_diffusion(variance, Array1D::Ones(3), -1.5).area_fraction), 0.0);
    EXPECT_THROW((void)stress_diffusion(variance, Array1D::Ones(2), 1.0), InvalidArgument);
    variance << 0.0, 2.0, 1.0;
    EXPECT_THROW((void)stress_diffusion(variance, Array1D::Ones(3), 1.0), InvalidArgument);
}

TEST(PerssonAdhesion, WithoutWorkOfAdhesionIsNonAdhesiveContact) {
    const auto scales = rough();
    for (const double pressure : {1e3, 1e5}) {
        const auto contact = adhesive_contact_at_scales(pressure, 0.0, scales);
        EXPECT_TRUE(contact.converged);
        EXPECT_TRUE((contact.area_fraction - contact_at_scales(pressure, scales).area_fraction).abs().maxCoeff() <
                    1e-4);
        EXPECT_EQ(contact.detachment_stress.maxCoeff(), 0.0);
    }
}

// the balance of Persson and Tosatti, scale by scale
TEST(PerssonAdhesion, OfFullContactMatchesThePerssonTosattiBalance) {
    const auto scales = rough();
    const double work = 50.0 * last(scales.stored_energy);
    const auto contact = adhesive_contact_at_scales(0.0, work, scales);
    ASSERT_TRUE(contact.converged);
    EXPECT_GT(last(contact.area_fraction), 1.0 - 1e-4);
    EXPECT_NEAR(contact.effective_work[0] / (work - last(scales.stored_energy)), 1.0, 1e-4);
    EXPECT_NEAR(last(contact.effective_work) / work, 1.0, 1e-12);
}

TEST(PerssonAdhesion, AreaIncreasesWithTheWorkOfAdhesion) {
    const auto scales = rough();
    const double stored = last(scales.stored_energy);
    double before = 0.0;
    for (const double share : {0.0, 0.2, 0.5, 1.0, 2.0, 5.0}) {
        const auto contact = adhesive_contact_at_scales(1e4, share * stored, scales);
        ASSERT_TRUE(contact.converged) << share;
        EXPECT_GE(last(contact.area_fraction), before - 1e-4) << share;
        before = last(contact.area_fraction);
    }
    EXPECT_GT(before, 0.9);
}

TEST(PerssonAdhesion, SeparatesUnderTension) {
    const auto scales = rough();
    const double work = 3.0 * last(scales.stored_energy);
    EXPECT_GT(last(adhesive_contact_at_scales(-100.0, work, scales).area_fraction), 0.1);
    const double tension = 1.1 * std::sqrt(last(scales.stiffness) * work);
    EXPECT_EQ(last(adhesive_contact_at_scales(-tension, work, scales).area_fraction), 0.0);
    EXPECT_THROW((void)adhesive_contact_at_scales(0.0, -1.0, scales), InvalidArgument);
}

}  // namespace
}  // namespace setae::persson::adhesive_test
