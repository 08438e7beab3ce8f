// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/global_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::global_fit_test {
namespace {

using contact::jkr::Contact;
using tests::rubber_on_diamond;

constexpr double modulus = 0.92e6;

GlobalBranch branch(const Contact& contact, double noise_share, std::mt19937_64& generator, double point,
                    const std::string& name) {
    const double least = 1.1 * contact::jkr::pull_off_at_fixed_load(contact).contact_radius;
    const double largest = contact::jkr::contact_radius_at_force(1e-3, contact);
    GlobalBranch result{.name = name, .bodies = rubber_on_diamond(contact.radius)};
    BranchData& data = result.data;
    const Array1D radii = Array1D::LinSpaced(80, least, largest);
    data.force = radii.unaryExpr([&](double a) { return contact::jkr::force(a, contact); });
    data.displacement = radii.unaryExpr([&](double a) { return contact::jkr::displacement(a, contact); }) + point;
    data.contact_radius = radii;
    data.force_noise = std::max(noise_share, 1e-9) * 1e-3;
    data.displacement_noise = std::max(noise_share, 1e-9) * 1e-5;
    data.contact_radius_noise = std::max(noise_share, 1e-9) * 1e-4;
    data.force = tests::with_noise(data.force, noise_share * 1e-3, generator);
    data.displacement = tests::with_noise(data.displacement, noise_share * 1e-5, generator);
    data.contact_radius = tests::with_noise(data.contact_radius, noise_share * 1e-4, generator);
    return result;
}

TEST(GlobalFit, RecoversSharedModulusAndWorksOfTwoSpheres) {
    std::mt19937_64 generator(1);
    const std::vector<GlobalBranch> branches{
        branch({.radius = 1.25e-3, .contact_modulus = modulus, .work_of_adhesion = 0.04}, 0.0, generator, 1e-6,
               "small"),
        branch({.radius = 2e-3, .contact_modulus = modulus, .work_of_adhesion = 0.10}, 0.0, generator, -2e-6, "large")};
    for (const Channels channels :
         {Channels::force_radius, Channels::force_displacement, Channels::force_displacement_radius}) {
        const GlobalFit fit = fit_globally(branches, {.fit = {.channels = channels}});
        EXPECT_TRUE(fit.converged);
        EXPECT_NEAR(fit.contact_modulus->value / modulus, 1.0, 1e-8);
        EXPECT_NEAR(fit.branches[0].work_of_adhesion->value / 0.04, 1.0, 1e-8);
        EXPECT_NEAR(fit.branches[1].work_of_adhesion->value / 0.10, 1.0, 1e-8);
        EXPECT_FALSE(fit.work_of_adhesion);
        EXPECT_EQ(fit.parameters.front(), "contact_modulus");
        if (channels == Channels::force_radius) continue;
        EXPECT_NEAR(fit.branches[1].contact_point.value / -2e-6, 1.0, 1e-8);
        EXPECT_EQ(fit.parameters.back(), "contact_point of large");
    }
}

TEST(GlobalFit, ErrorsShrinkAsTheRootOfTheNumberOfBranches) {
    std::mt19937_64 generator(7);
    const Contact contact{.radius = 1.25e-3, .contact_modulus = modulus, .work_of_adhesion = 0.04};
    std::vector<GlobalBranch> branches;
    for (int i = 0; i < 16; ++i)
        branches.push_back(branch(contact, 0.01, generator, 1e-6 * i, "loop " + std::to_string(i)));
    const GlobalOptions both{.share_work_of_adhesion = true, .fit = {.channels = Channels::force_radius}};
    double alone = 0.0;
    const GlobalFit fit = fit_globally(branches, both);
    for (const GlobalBranchFit& own : fit.branches) alone += own.separate.contact_modulus.standard_error / 16.0;
    // each error is known to 1/√(2·80)
    EXPECT_NEAR(4.0 * fit.contact_modulus->standard_error / alone, 1.0, 0.1);
    EXPECT_LT(std::abs(fit.contact_modulus->value - modulus), 3.0 * fit.contact_modulus->standard_error);
    EXPECT_LT(std::abs(fit.work_of_adhesion->value - 0.04), 3.0 * fit.work_of_adhesion->standard_error);
    EXPECT_GT(fit.sharing.p_value, 0.01);
    EXPECT_EQ(fit.sharing.extra_parameters, 30.0);
    EXPECT_NEAR(fit.chi2_reduced, 1.0, 4.0 * std::sqrt(2.0 / fit.sharing.degrees_of_freedom));
}

TEST(GlobalFit, DetectsBranchesThatDiffer) {
    std::mt19937_64 generator(3);
    const std::vector<GlobalBranch> branches{
        branch({.radius = 1.25e-3, .contact_modulus = modulus, .work_of_adhesion = 0.04}, 0.003, generator, 0.0,
               "first"),
        branch({.radius = 1.25e-3, .contact_modulus = 1.1 * modulus, .work_of_adhesion = 0.04}, 0.003, generator, 0.0,
               "second")};
    EXPECT_LT(fit_globally(branches).sharing.p_value, 1e-6);
}

TEST(GlobalFit, OfOneBranchEqualsTheSingleFit) {
    std::mt19937_64 generator(5);
    const GlobalBranch one =
        branch({.radius = 1.25e-3, .contact_modulus = modulus, .work_of_adhesion = 0.04}, 0.01, generator, 0.0, "one");
    const GlobalFit fit = fit_globally({one});
    const ModelFit own = fit_model(one.data, one.bodies);
    EXPECT_NEAR(fit.contact_modulus->value / own.contact_modulus.value, 1.0, 1e-7);
    EXPECT_NEAR(fit.contact_modulus->standard_error / own.contact_modulus.standard_error, 1.0, 1e-4);
    EXPECT_EQ(fit.sharing.p_value, 1.0);
}

TEST(GlobalFit, RequiresASharedParameterAndNamesBadBranches) {
    std::mt19937_64 generator(5);
    GlobalBranch one = branch({.radius = 1.25e-3, .contact_modulus = modulus, .work_of_adhesion = 0.04}, 0.01,
                              generator, 0.0, "spot 7");
    EXPECT_THROW((void)fit_globally({}), InvalidArgument);
    EXPECT_THROW((void)fit_globally({one}, {.share_contact_modulus = false}), InvalidArgument);
    EXPECT_THROW((void)fit_globally({one}, {.fit = {.model = ContactModel::transition}}), InvalidArgument);
    one.data.displacement = Array1D();
    one.data.contact_radius = Array1D();
    try {
        (void)fit_globally({one});
        FAIL() << "a branch of force alone was fitted";
    } catch (const UndefinedDataError& error) {
        EXPECT_EQ(std::string(error.what()).substr(0, 8), "spot 7: ");
    }
}

}  // namespace
}  // namespace setae::loops::global_fit_test
