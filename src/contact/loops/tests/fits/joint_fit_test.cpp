// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "noisy_branch.hpp"
#include "pulls.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::joint_fit_test {
namespace {

using contact::jkr::Contact;
using tests::branch_of;
using tests::BranchShape;
using tests::contact_point;
using tests::rubber_on_diamond;

constexpr Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};

/// Without noise, but with weights.
BranchData clean(const Contact& contact, BranchShape shape = BranchShape::loading) {
    BranchData data = branch_of(contact, shape, 200);
    data.force_noise = 1e-6;
    data.displacement_noise = 1e-8;
    data.contact_radius_noise = 1e-7;
    return data;
}

/// Between means of neighbours and the curve's bend lies nothing where the noise given is as small as this.
TEST(JointFit, RecoversModulusWorkAndContactPointFromNoiseFreeData) {
    for (const double work : {0.001, 0.04, 2.0})
        for (const auto shape : {BranchShape::loading, BranchShape::unloading}) {
            const Contact contact{.radius = lens.radius, .contact_modulus = 0.92e6, .work_of_adhesion = work};
            BranchData data = clean(contact, shape);
            // so small that the offset of curvature, half its radius over the noise squared, vanishes
            data.force_noise *= 1e-5;
            data.displacement_noise *= 1e-5;
            data.contact_radius_noise *= 1e-5;
            const JkrFit joint = fit_joint(data, rubber_on_diamond());
            EXPECT_TRUE(joint.converged);
            EXPECT_NEAR(joint.contact_point.value / contact_point, 1.0, 1e-8);
            for (const JkrFit& fit :
                 {joint, fit_radius_force(data, rubber_on_diamond(), RadiusErrors::effective_variance),
                  fit_force_displacement(data, rubber_on_diamond())}) {
                EXPECT_NEAR(fit.contact_modulus.value / contact.contact_modulus, 1.0, 1e-8)
                    << fit.method << " W " << work;
                EXPECT_NEAR(fit.work_of_adhesion.value / work, 1.0, 1e-8) << fit.method << " W " << work;
            }
        }
}

TEST(JointFit, HasSmallerErrorsThanItsParts) {
    std::mt19937_64 generator(1);
    const BranchData data = tests::noisy(branch_of(lens, BranchShape::loading, 200), 50.0, generator);
    const JkrFit joint = fit_joint(data, rubber_on_diamond());
    for (const JkrFit& part : {fit_radius_force(data, rubber_on_diamond(), RadiusErrors::effective_variance),
                               fit_force_displacement(data, rubber_on_diamond())}) {
        EXPECT_LT(joint.contact_modulus.standard_error, part.contact_modulus.standard_error) << part.method;
        EXPECT_LT(joint.work_of_adhesion.standard_error, part.work_of_adhesion.standard_error) << part.method;
    }
}

/// The pair's covariance is that of the definition: standardised by it, both residuals scatter by 1.
TEST(JointFit, ResidualsUseTheCovarianceOfForceAndDepth) {
    std::mt19937_64 generator(2);
    constexpr Index n = 2000;
    const BranchData truth = branch_of(lens, BranchShape::loading, n);
    const BranchData data = tests::noisy(truth, 100.0, generator);
    const JkrFit fit = fit_joint(data, rubber_on_diamond());
    ASSERT_EQ(fit.residuals.size(), n);
    ASSERT_EQ(fit.depth_residuals.size(), n);
    double force = 0.0, depth = 0.0;
    for (Index i = 0; i < n; ++i) {
        const double a = truth.contact_radius[i], step = 1e-4 * a;
        const double by_force =
            (contact::jkr::force(a + step, lens) - contact::jkr::force(a - step, lens)) / (2.0 * step);
        const double by_depth =
            (contact::jkr::displacement(a + step, lens) - contact::jkr::displacement(a - step, lens)) / (2.0 * step);
        force += std::pow(fit.residuals[i], 2) /
                 (std::pow(data.force_noise, 2) + std::pow(by_force * data.contact_radius_noise, 2)) / n;
        depth += std::pow(fit.depth_residuals[i], 2) /
                 (std::pow(data.displacement_noise, 2) + std::pow(by_depth * data.contact_radius_noise, 2)) / n;
    }
    // standard deviation of the mean of 2000 squares: 3.2 %
    EXPECT_NEAR(force, 1.0, 0.1);
    EXPECT_NEAR(depth, 1.0, 0.1);
    EXPECT_NEAR(fit.chi2_reduced, 1.0, 0.07);
}

TEST(JointFit, AccountsForNoiseSharedByForceAndDisplacement) {
    // the displacement is the stage's less what the force sensor bends: its noise is the sensor's
    constexpr int seeds = 100;
    const BranchData truth = branch_of(lens, BranchShape::loading, 200);
    int modulus = 0, work = 0;
    setae::tests::Pulls modulus_pulls, work_pulls;
    double chi2 = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        BranchData data = tests::noisy(truth, 50.0, generator);
        const double stiffness = data.force_noise / (2.0 * data.displacement_noise);
        data.displacement -= (data.force - truth.force) / stiffness;
        data.force_displacement_covariance = -data.force_noise * data.force_noise / stiffness;
        data.displacement_noise = std::hypot(data.displacement_noise, data.force_noise / stiffness);
        const JkrFit fit = fit_joint(data, rubber_on_diamond());
        modulus += tests::covers(fit.contact_modulus, lens.contact_modulus);
        work += tests::covers(fit.work_of_adhesion, lens.work_of_adhesion);
        modulus_pulls.add(fit.contact_modulus, lens.contact_modulus);
        work_pulls.add(fit.work_of_adhesion, lens.work_of_adhesion);
        chi2 += fit.chi2_reduced / seeds;
    }
    // 95 expected, standard deviation 2.2
    EXPECT_GE(modulus, 88);
    EXPECT_GE(work, 88);
    expect_honest(modulus_pulls, "E*");
    expect_honest(work_pulls, "W");
    EXPECT_NEAR(chi2, 1.0, 0.03);
}

TEST(JointFit, CoversTrueValuesWithCorrelatedNoise) {
    constexpr int seeds = 60;
    constexpr double follows = 0.8;
    const BranchData truth = branch_of(lens, BranchShape::loading, 400);
    int modulus = 0, work = 0;
    setae::tests::Pulls modulus_pulls, work_pulls;
    double correlated_samples = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        std::normal_distribution<double> normal;
        BranchData data = tests::noisy(truth, 50.0, generator);
        const auto correlated = [&](Array1D& series, const Array1D& of, double noise) {
            double at = normal(generator);
            for (Index i = 0; i < series.size(); ++i) {
                series[i] = of[i] + noise * at;
                at = follows * at + std::sqrt(1.0 - follows * follows) * normal(generator);
            }
        };
        correlated(data.force, truth.force, data.force_noise);
        correlated(data.displacement, truth.displacement, data.displacement_noise);
        correlated(data.contact_radius, truth.contact_radius, data.contact_radius_noise);
        const JkrFit fit = fit_joint(data, rubber_on_diamond());
        modulus += tests::covers(fit.contact_modulus, lens.contact_modulus);
        work += tests::covers(fit.work_of_adhesion, lens.work_of_adhesion);
        modulus_pulls.add(fit.contact_modulus, lens.contact_modulus);
        work_pulls.add(fit.work_of_adhesion, lens.work_of_adhesion);
        correlated_samples += fit.correlated_samples / seeds;
    }
    // 57 of 60 expected, standard deviation 1.7; independent errors would cover about half
    EXPECT_GE(modulus, 52);
    EXPECT_GE(work, 52);
    expect_honest(modulus_pulls, "E*");
    expect_honest(work_pulls, "W");
    EXPECT_NEAR(correlated_samples, 9.0, 2.0);  // (1 + φ)/(1 − φ)
}

TEST(JointFit, RefusesMissingChannels) {
    BranchData data = clean(lens);
    data.force_noise = data.displacement_noise = 0.0;
    EXPECT_THROW((void)fit_joint(data, rubber_on_diamond()), InvalidArgument);
    data = clean(lens);
    data.contact_radius_noise = 0.0;
    EXPECT_THROW((void)fit_joint(data, rubber_on_diamond()), InvalidArgument);
    data = clean(lens);
    data.contact_radius = Array1D();
    EXPECT_THROW((void)fit_joint(data, rubber_on_diamond()), UndefinedDataError);
    data = clean(lens);
    data.displacement = Array1D();
    EXPECT_THROW((void)fit_joint(data, rubber_on_diamond()), UndefinedDataError);
    EXPECT_THROW((void)fit_joint(clean(lens), rubber_on_diamond(0.0)), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::joint_fit_test
