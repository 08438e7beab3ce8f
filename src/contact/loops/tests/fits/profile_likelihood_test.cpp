// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/profile_likelihood.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "noisy_branch.hpp"
#include "pulls.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops::profile_likelihood_test {
namespace {

using tests::branch_of;
using tests::BranchShape;
using tests::rubber_on_diamond;

constexpr contact::jkr::Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};

BranchData branch(double signal_to_noise, std::uint64_t seed, Index samples = 400) {
    std::mt19937_64 generator(seed);
    return tests::noisy(branch_of(lens, BranchShape::loading, samples), signal_to_noise, generator);
}

constexpr ProfiledFit all_fits[] = {ProfiledFit::effective_variance, ProfiledFit::force_displacement,
                                    ProfiledFit::joint};

TEST(ProfileLikelihood, IsTheParabolaOfTheStandardErrorForLowNoise) {
    for (const auto fit : all_fits) {
        const ProfileLikelihood found =
            profile_likelihood(branch(300.0, 1), rubber_on_diamond(), {.fit = fit, .points = 9});
        for (const ParameterProfile* profile : {&found.contact_modulus, &found.work_of_adhesion}) {
            const double best = profile->estimate.value, error = profile->estimate.standard_error;
            for (Index i = 0; i < profile->values.size(); ++i) {
                const double parabola = std::pow((profile->values[i] - best) / error, 2);
                // the third order is that of the relative error, below 1 %, the information that noise pretends a few
                // per cent
                EXPECT_NEAR(profile->chi2_rise[i], parabola, 0.06 * parabola + 1e-3) << found.fit.method;
            }
            ASSERT_TRUE(profile->estimate.interval);
            const double half = std::sqrt(profile->threshold) * error;
            EXPECT_NEAR(profile->estimate.interval->lower, best - half, 0.04 * half);
            EXPECT_NEAR(profile->estimate.interval->upper, best + half, 0.04 * half);
        }
    }
}

TEST(ProfileLikelihood, HasItsMinimumAtTheFitAndItsThresholdAtTheEnds) {
    for (const auto fit : all_fits) {
        const BranchData data = branch(20.0, 3);
        const ProfileLikelihood found =
            profile_likelihood(data, rubber_on_diamond(), {.fit = fit, .points = 3, .reach = 1.0});
        for (const ParameterProfile* profile : {&found.contact_modulus, &found.work_of_adhesion}) {
            ASSERT_TRUE(profile->estimate.interval) << found.fit.method;
            // the first and last of three points are the ends, the middle one their centre
            EXPECT_NEAR(profile->values[0], profile->estimate.interval->lower, 1e-9 * profile->estimate.value);
            EXPECT_NEAR(profile->chi2_rise[0], profile->threshold, 1e-3 * profile->threshold) << found.fit.method;
            EXPECT_NEAR(profile->chi2_rise[2], profile->threshold, 1e-3 * profile->threshold) << found.fit.method;
            EXPECT_LT(profile->chi2_rise[1], 0.1 * profile->threshold);
        }
    }
}

TEST(ProfileLikelihood, OfWorkIsSkewedToLargerValuesInStrongNoise) {
    const ProfileLikelihood found =
        profile_likelihood(branch(10.0, 4), rubber_on_diamond(), {.fit = ProfiledFit::force_displacement, .points = 3});
    const Estimate& work = found.work_of_adhesion.estimate;
    ASSERT_TRUE(work.interval);
    EXPECT_GT(work.interval->upper - work.value, 1.1 * (work.value - work.interval->lower));
}

TEST(ProfileLikelihood, CoversTrueValues) {
    constexpr int seeds = 40;
    int modulus = 0, work = 0;
    setae::tests::Pulls modulus_pulls, work_pulls;
    const auto pull = [](setae::tests::Pulls& pulls, const Estimate& found, double truth) {
        pulls.add(found.value, truth, (found.interval->upper - found.interval->lower) / (2.0 * 1.96));
    };
    for (int seed = 0; seed < seeds; ++seed) {
        const BranchData data = branch(20.0, static_cast<std::uint64_t>(seed));
        const ProfileLikelihood found =
            profile_likelihood(data, rubber_on_diamond(), {.fit = ProfiledFit::joint, .points = 3});
        modulus += tests::covers(found.contact_modulus.estimate, lens.contact_modulus);
        work += tests::covers(found.work_of_adhesion.estimate, lens.work_of_adhesion);
        pull(modulus_pulls, found.contact_modulus.estimate, lens.contact_modulus);
        pull(work_pulls, found.work_of_adhesion.estimate, lens.work_of_adhesion);
    }
    // 38 of 40 expected, standard deviation 1.4
    EXPECT_GE(modulus, 34);
    EXPECT_GE(work, 34);
    expect_honest(modulus_pulls, "E*");
    expect_honest(work_pulls, "W");
}

TEST(ProfileLikelihood, RefusesImpossibleOptions) {
    const BranchData data = branch(100.0, 1);
    EXPECT_THROW((void)profile_likelihood(data, rubber_on_diamond(), {.level = 1.0}), InvalidArgument);
    EXPECT_THROW((void)profile_likelihood(data, rubber_on_diamond(), {.points = 2}), InvalidArgument);
    EXPECT_THROW((void)profile_likelihood(data, rubber_on_diamond(), {.reach = 0.0}), InvalidArgument);
    BranchData unknown = data;
    unknown.contact_radius_noise = 0.0;
    EXPECT_THROW((void)profile_likelihood(unknown, rubber_on_diamond()), InvalidArgument);
}

JkrFit fit_with(double freedom) {
    JkrFit fit{.contact_modulus = {.value = 1e6, .standard_error = 1e4},
               .work_of_adhesion = {.value = 0.04, .standard_error = 1e-3}};
    fit.contact_modulus.degrees_of_freedom = freedom;
    fit.covariance.resize(2, 2);
    fit.covariance << 1e8, 6.0, 6.0, 1e-6;
    fit.correlation = 0.6;
    return fit;
}

TEST(ErrorEllipse, HasAConstantQuadraticForm) {
    const JkrFit fit = fit_with(1e9);
    const ErrorEllipse ellipse = error_ellipse(fit, 0.95);
    const Eigen::Matrix2d inverse = Eigen::Matrix2d(fit.covariance).inverse();
    for (Index i = 0; i < ellipse.contact_modulus.size(); ++i) {
        const Eigen::Vector2d from(ellipse.contact_modulus[i] - 1e6, ellipse.work_of_adhesion[i] - 0.04);
        EXPECT_NEAR(from.dot(inverse * from), 5.991464547, 1e-6);  // χ² of 2 degrees of freedom
    }
    EXPECT_NEAR(ellipse.contact_modulus[0], ellipse.contact_modulus.tail(1)[0], 1e-6);
}

TEST(ErrorEllipse, OfFewDegreesOfFreedomUsesTheFDistribution) {
    const JkrFit fit = fit_with(10.0);
    // F(0.95; 2, 10) = 4.102821
    EXPECT_NEAR(std::pow((error_ellipse(fit).contact_modulus[0] - 1e6) / 1e4, 2), 2.0 * 4.102821, 1e-5);
}

TEST(ErrorEllipse, RefusesAFitWithoutCovariance) {
    EXPECT_THROW((void)error_ellipse(JkrFit{}), UndefinedDataError);
    EXPECT_THROW((void)error_ellipse(fit_with(10.0), 0.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::profile_likelihood_test
