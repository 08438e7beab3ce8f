// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/jkr_fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::jkr_fits_test {
namespace {

using contact::jkr::Contact;
using tests::rubber_on_diamond;

constexpr Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
constexpr double contact_point = 3.7e-6;

/// Equilibrium at evenly spaced forces, from one share of the pull-off force to 1 mN.
BranchData branch(const Contact& contact, double from_share = -0.8, Index n = 120) {
    BranchData data;
    data.force = Array1D::LinSpaced(n, from_share * -contact::jkr::pull_off_at_fixed_load(contact).force, 1e-3);
    data.contact_radius = contact::jkr::contact_radius_at_force(data.force, contact);
    data.displacement = contact::jkr::displacement_at_force(data.force, contact) + contact_point;
    return data;
}

void expect_recovered(const JkrFit& fit, const Contact& contact) {
    EXPECT_TRUE(fit.converged) << fit.method;
    EXPECT_NEAR(fit.contact_modulus.value / contact.contact_modulus, 1.0, 1e-8) << fit.method;
    EXPECT_NEAR(fit.work_of_adhesion.value / contact.work_of_adhesion, 1.0, 1e-8) << fit.method;
    EXPECT_NEAR(fit.youngs_modulus.value / (0.75 * contact.contact_modulus), 1.0, 2e-6) << fit.method;
}

TEST(JkrFits, RecoverModulusAndWorkFromNoiseFreeData) {
    for (const double work : {0.001, 0.04, 2.0}) {
        const Contact contact{.radius = lens.radius, .contact_modulus = 0.92e6, .work_of_adhesion = work};
        const BranchData data = branch(contact);
        expect_recovered(fit_radius_force(data, rubber_on_diamond()), contact);
        expect_recovered(fit_linear_form(data, rubber_on_diamond()), contact);
        const JkrFit depth = fit_force_displacement(data, rubber_on_diamond());
        expect_recovered(depth, contact);
        EXPECT_NEAR(depth.contact_point.value / contact_point, 1.0, 1e-8);
        const PointwiseModulus pointwise = fit_pointwise_modulus(data, rubber_on_diamond());
        EXPECT_NEAR(pointwise.contact_modulus.value / contact.contact_modulus, 1.0, 1e-8);
        EXPECT_NEAR(pointwise.contact_point.value / contact_point, 1.0, 1e-8);
        EXPECT_LT((pointwise.pointwise / contact.contact_modulus - 1.0).abs().maxCoeff(), 1e-7);
    }
}

TEST(JkrFits, RecoverZeroWorkFromHertzianData) {
    const Contact dry{.radius = lens.radius, .contact_modulus = 0.92e6, .work_of_adhesion = 0.0};
    const BranchData data = branch(dry);  // forces from 0 to 1 mN
    BranchData pressed = data;
    pressed.force = data.force.tail(119);
    pressed.contact_radius = data.contact_radius.tail(119);
    pressed.displacement = Array1D();
    const JkrFit fit = fit_radius_force(pressed, rubber_on_diamond());
    EXPECT_NEAR(fit.contact_modulus.value / dry.contact_modulus, 1.0, 1e-8);
    EXPECT_NEAR(fit.work_of_adhesion.value, 0.0, 1e-12);
}

TEST(JkrFits, DoNotDependOnUnits) {
    const BranchData data = branch(lens);
    std::mt19937_64 generator(3);
    BranchData noisy = data;
    noisy.displacement = tests::with_noise(data.displacement, 1e-9, generator);
    const JkrFit metres = fit_force_displacement(noisy, rubber_on_diamond());
    // lengths in millimetres and forces in newtons: E* in N/mm², W in N/mm
    BranchData millimetres = noisy;
    millimetres.displacement = 1e3 * noisy.displacement;
    LensAndCounterBody bodies = rubber_on_diamond(1.25);
    bodies.counter_youngs_modulus = 1.1e6;
    const JkrFit scaled = fit_force_displacement(millimetres, bodies);
    EXPECT_NEAR(scaled.contact_modulus.value * 1e6 / metres.contact_modulus.value, 1.0, 1e-7);
    EXPECT_NEAR(scaled.work_of_adhesion.value * 1e3 / metres.work_of_adhesion.value, 1.0, 1e-7);
    EXPECT_NEAR(scaled.work_of_adhesion.standard_error * 1e3 / metres.work_of_adhesion.standard_error, 1.0, 1e-6);
}

TEST(JkrFits, TolerateForcesBelowTheFittedPullOff) {
    BranchData data = branch(lens, -1.0);
    data.force[0] *= 1.001;
    const JkrFit fit = fit_force_displacement(data, rubber_on_diamond());
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.work_of_adhesion.value, lens.work_of_adhesion, 0.01 * lens.work_of_adhesion);
}

/// How many of the seeded noisy fits have the true value within 1.96 standard errors.
struct Coverage {
    int modulus = 0;
    int work = 0;
    double mean_chi2 = 0.0;
};

Coverage coverage(int seeds, const Contact& truth, const std::function<JkrFit(std::mt19937_64&)>& fit) {
    Coverage result;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        const JkrFit found = fit(generator);
        const auto covers = [](const Estimate& value, double true_value) {
            return std::abs(value.value - true_value) < 1.96 * value.standard_error;
        };
        result.modulus += covers(found.contact_modulus, truth.contact_modulus);
        result.work += covers(found.work_of_adhesion, truth.work_of_adhesion);
        result.mean_chi2 += found.chi2_reduced / seeds;
    }
    return result;
}

/// 200 fits: 95 % ± 3 binomial standard deviations of 1.5 %.
constexpr int seeds = 200;
constexpr int fewest = 181, most = 199;

TEST(JkrFits, CoverTrueValuesWithNoiseInDepth) {
    const BranchData clean = branch(lens);
    const Coverage found = coverage(seeds, lens, [&](std::mt19937_64& generator) {
        BranchData data = clean;
        data.displacement_noise = 5e-9;
        data.displacement = tests::with_noise(clean.displacement, data.displacement_noise, generator);
        return fit_force_displacement(data, rubber_on_diamond());
    });
    EXPECT_GE(found.modulus, fewest);
    EXPECT_LE(found.modulus, most);
    EXPECT_GE(found.work, fewest);
    EXPECT_LE(found.work, most);
    EXPECT_NEAR(found.mean_chi2, 1.0, 0.05);
}

TEST(JkrFits, CoverTrueValuesWithNoiseInRadius) {
    const BranchData clean = branch(lens);
    const Coverage found = coverage(seeds, lens, [&](std::mt19937_64& generator) {
        BranchData data = clean;
        data.contact_radius_noise = 3e-7;
        data.contact_radius = tests::with_noise(clean.contact_radius, data.contact_radius_noise, generator);
        return fit_radius_force(data, rubber_on_diamond());
    });
    EXPECT_GE(found.modulus, fewest);
    EXPECT_LE(found.modulus, most);
    EXPECT_GE(found.work, fewest);
    EXPECT_LE(found.work, most);
    EXPECT_NEAR(found.mean_chi2, 1.0, 0.05);
}

TEST(JkrFits, RequireEffectiveVarianceForVanishingAdhesion) {
    const Contact weak{.radius = lens.radius, .contact_modulus = 0.92e6, .work_of_adhesion = 1e-6};
    const BranchData clean = branch(weak, -0.5);
    constexpr double force_noise = 2e-6, radius_noise = 2e-7;
    const auto fits_with = [&](RadiusErrors errors) {
        return coverage(seeds, weak, [&, errors](std::mt19937_64& generator) {
            BranchData data = clean;
            data.force_noise = force_noise;
            data.contact_radius_noise = radius_noise;
            data.force = tests::with_noise(clean.force, force_noise, generator);
            data.contact_radius = tests::with_noise(clean.contact_radius, radius_noise, generator);
            return fit_radius_force(data, rubber_on_diamond(), errors);
        });
    };
    EXPECT_GE(fits_with(RadiusErrors::effective_variance).modulus, fewest);
    EXPECT_LT(fits_with(RadiusErrors::radius_only).modulus, fewest);
}

TEST(EnergyReleaseRates, EqualWorkOfAdhesionWithAndWithoutMeasuredRadius) {
    BranchData data = branch(lens);
    for (const bool measured : {true, false}) {
        if (!measured) data.contact_radius = Array1D();
        const EnergyReleaseRate rates = energy_release_rates(data, lens.radius, lens.contact_modulus, contact_point);
        EXPECT_EQ(rates.radius_measured, measured);
        EXPECT_LT((rates.energy_release_rate / lens.work_of_adhesion - 1.0).abs().maxCoeff(), 1e-8);
    }
}

TEST(JkrFits, RefuseMissingChannels) {
    BranchData data = branch(lens);
    data.contact_radius = Array1D();
    EXPECT_THROW((void)fit_radius_force(data, rubber_on_diamond()), UndefinedDataError);
    EXPECT_THROW((void)fit_linear_form(data, rubber_on_diamond()), UndefinedDataError);
    EXPECT_THROW((void)fit_pointwise_modulus(data, rubber_on_diamond()), UndefinedDataError);
    data.displacement = Array1D();
    EXPECT_THROW((void)fit_force_displacement(data, rubber_on_diamond()), UndefinedDataError);
    EXPECT_THROW((void)fit_force_displacement(branch(lens), rubber_on_diamond(0.0)), InvalidArgument);
    EXPECT_THROW((void)fit_radius_force(branch(lens), rubber_on_diamond(), RadiusErrors::effective_variance),
                 InvalidArgument);
    EXPECT_THROW((void)fit_force_displacement(branch(lens, -0.8, 3), rubber_on_diamond()), UndefinedDataError);
}

TEST(JkrFits, RefuseADepthThatFallsWithForce) {
    BranchData data = branch(lens);
    data.displacement = -data.displacement;
    EXPECT_THROW((void)fit_force_displacement(data, rubber_on_diamond()), UndefinedDataError);
}

TEST(YoungsModulus, IsUndefinedBeyondTheCounterBody) {
    const LensAndCounterBody soft_counter{.radius = 1.0, .counter_youngs_modulus = 1e6, .counter_poisson_ratio = 0.5};
    EXPECT_TRUE(std::isnan(youngs_modulus({2e6, 0.0}, soft_counter).value));
    EXPECT_NEAR(youngs_modulus({1e5, 1e3}, rubber_on_diamond()).standard_error, 750.0, 0.01);
}

TEST(YoungsModulus, OfRubberOnARigidBodyIsThreeQuartersOfContactModulus) {
    const LensAndCounterBody rigid{.radius = 1.0, .counter_youngs_modulus = INFINITY};
    EXPECT_DOUBLE_EQ(youngs_modulus({4e6, 1e5}, rigid).value, 3e6);
    EXPECT_DOUBLE_EQ(youngs_modulus({4e6, 1e5}, rigid).standard_error, 0.75e5);
}

}  // namespace
}  // namespace setae::loops::jkr_fits_test
