// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/transition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "setae/contact/dmt.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::transition::transition_test {
namespace {

constexpr AdhesiveContact tip{.radius = 20e-9, .contact_modulus = 60e9, .work_of_adhesion = 0.1};

maugis_dugdale::Contact with(double lambda) {
    return {.radius = tip.radius,
            .contact_modulus = tip.contact_modulus,
            .work_of_adhesion = tip.work_of_adhesion,
            .cohesive_stress = maugis_dugdale::cohesive_stress(lambda, tip)};
}

/// Largest deviation of contact radii from Maugis and Dugdale's, over a0, for F from `from` |Fc| to 10 |Fc|.
double deviation(double lambda, double from) {
    const maugis_dugdale::Contact contact = with(lambda);
    const RadiusCurve curve = curve_of(contact);
    const Array1D loads = Array1D::LinSpaced(2001, from, 10.0) * std::abs(curve.pull_off_force);
    return (contact_radius(loads, curve) - maugis_dugdale::contact_radius_at_force(loads, contact)).abs().maxCoeff() /
           curve.zero_load_radius;
}

/// a0 (α/(1 + α))^(2/3)
double pull_off_radius(const RadiusCurve& curve) {
    const double share = std::cbrt(curve.transition_share / (1.0 + curve.transition_share));
    return curve.zero_load_radius * share * share;
}

TEST(Transition, IsDmtAndJkrInItsLimits) {
    const RadiusCurve dmt_end{.zero_load_radius = dmt::contact_radius_at_force(0.0, tip),
                              .pull_off_force = dmt::pull_off(tip).force,
                              .transition_share = 0.0};
    const RadiusCurve jkr_end{.zero_load_radius = jkr::contact_radius_at_force(0.0, tip),
                              .pull_off_force = jkr::pull_off_at_fixed_load(tip).force,
                              .transition_share = 1.0};
    for (const double load : {-8e-9, 0.0, 1e-8, 1e-6}) {
        EXPECT_NEAR(contact_radius(load, dmt_end) / dmt::contact_radius_at_force(load, tip), 1.0, 1e-14);
        EXPECT_NEAR(contact_radius(load, jkr_end) / jkr::contact_radius_at_force(load, tip), 1.0, 1e-14);
    }
    EXPECT_NEAR(pull_off_radius(jkr_end) / jkr::pull_off_at_fixed_load(tip).contact_radius, 1.0, 1e-14);
    EXPECT_EQ(pull_off_radius(dmt_end), 0.0);
}

TEST(Transition, RadiusInvertsForce) {
    for (const double alpha : {0.0, 0.3, 1.0}) {
        const RadiusCurve curve{.zero_load_radius = 2e-9, .pull_off_force = -1e-8, .transition_share = alpha};
        for (const double load : {-0.99e-8, -0.5e-8, 0.0, 1e-7})
            EXPECT_NEAR(force(contact_radius(load, curve), curve), load, 1e-10 * (1e-8 + std::abs(load)));
        EXPECT_DOUBLE_EQ(contact_radius(0.0, curve), 2e-9);
        EXPECT_NEAR(force(pull_off_radius(curve), curve), -1e-8, 1e-20);
    }
}

TEST(Transition, IsUndefinedBeyondPullOff) {
    const RadiusCurve curve{.zero_load_radius = 2e-9, .pull_off_force = -1e-8, .transition_share = 0.3};
    EXPECT_TRUE(std::isnan(contact_radius(-1.001e-8, curve)));
    EXPECT_TRUE(std::isnan(contact_radius(undefined, curve)));
    EXPECT_TRUE(std::isnan(force(0.99 * pull_off_radius(curve), curve)));
}

TEST(Transition, DeviatesFromMaugisDugdaleAsDocumented) {
    double everywhere = 0.0;
    for (const double lambda : {0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0})
        everywhere = std::max(everywhere, deviation(lambda, -0.95));
    EXPECT_LT(everywhere, 0.016);
    EXPECT_GT(everywhere, 0.014);  // so that the header does not overstate it
    for (const double lambda : {1.5, 2.0, 5.0, 20.0, 100.0}) EXPECT_LT(deviation(lambda, -0.95), 0.007) << lambda;
    double at_pull_off = 0.0;
    for (const double lambda : {0.01, 0.03, 0.05, 0.07, 0.1, 0.3, 1.0})
        at_pull_off = std::max(at_pull_off, deviation(lambda, -1.0 + 1e-9));
    EXPECT_LT(at_pull_off, 0.06);
    EXPECT_GT(at_pull_off, 0.05);
}

TEST(Transition, ShareConvertsToTransitionParameterAndBack) {
    for (const double lambda : {1e-3, 0.1, 1.0, 5.0})
        EXPECT_NEAR(transition_parameter(transition_share(lambda)) / lambda, 1.0, 1e-10);
    EXPECT_NEAR(transition_parameter(0.5), -0.924 * std::log(0.49), 1e-15);
}

TEST(Transition, RecoversTheContactOfItsCurve) {
    for (const double lambda : {0.05, 0.5, 3.0}) {
        const maugis_dugdale::Contact contact = with(lambda), back = contact_of(curve_of(contact), contact.radius);
        EXPECT_NEAR(back.contact_modulus / contact.contact_modulus, 1.0, 1e-10);
        EXPECT_NEAR(back.work_of_adhesion / contact.work_of_adhesion, 1.0, 1e-10);
        EXPECT_NEAR(back.cohesive_stress / contact.cohesive_stress, 1.0, 1e-10);
    }
}

TEST(Transition, OfSeriesEqualsThatOfEachValue) {
    const RadiusCurve curve{.zero_load_radius = 2e-9, .pull_off_force = -1e-8, .transition_share = 0.3};
    const Array1D loads = Array1D::LinSpaced(4, -1e-8, 1e-8);
    const Array1D radii = contact_radius(loads, curve);
    for (Index i = 0; i < 4; ++i) EXPECT_EQ(radii[i], contact_radius(loads[i], curve));
    EXPECT_EQ(force(radii, curve)[3], force(radii[3], curve));
}

TEST(Transition, RefusesValuesOutsideItsDomain) {
    for (const RadiusCurve& bad :
         {RadiusCurve{.zero_load_radius = 0.0, .pull_off_force = -1.0, .transition_share = 0.5},
          RadiusCurve{.zero_load_radius = 1.0, .pull_off_force = 1.0, .transition_share = 0.5},
          RadiusCurve{.zero_load_radius = 1.0, .pull_off_force = -1.0, .transition_share = 1.1},
          RadiusCurve{.zero_load_radius = 1.0, .pull_off_force = -1.0, .transition_share = undefined}}) {
        EXPECT_THROW((void)contact_radius(0.0, bad), InvalidArgument);
        EXPECT_THROW((void)contact_of(bad, 1.0), InvalidArgument);
    }
    const RadiusCurve good{.zero_load_radius = 1.0, .pull_off_force = -1.0, .transition_share = 0.5};
    EXPECT_THROW((void)force(-1.0, good), InvalidArgument);
    EXPECT_THROW((void)contact_of(good, -1.0), InvalidArgument);
    EXPECT_THROW((void)transition_share(0.0), InvalidArgument);
    EXPECT_THROW((void)transition_parameter(0.0), InvalidArgument);
    EXPECT_THROW((void)transition_parameter(0.99), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::transition::transition_test
