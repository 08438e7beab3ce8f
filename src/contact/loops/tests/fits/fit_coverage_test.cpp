// SPDX-License-Identifier: GPL-3.0-or-later
// Coverage of 95 % intervals of E* and W for any noise: 40 seeds of a branch of 1000 samples each.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "noisy_branch.hpp"
#include "pulls.hpp"
#include "setae/loops/jkr_fits.hpp"

namespace setae::loops::fit_coverage_test {
namespace {

using tests::BranchShape;

constexpr contact::jkr::Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};

struct Case {
    const char* name;
    JkrFit (*fit)(const BranchData&);
    BranchShape shape;
    double signal_to_noise;
};

JkrFit effective_variance(const BranchData& data) {
    return fit_radius_force(data, tests::rubber_on_diamond(), RadiusErrors::effective_variance);
}
JkrFit force_displacement(const BranchData& data) { return fit_force_displacement(data, tests::rubber_on_diamond()); }
JkrFit joint(const BranchData& data) { return fit_joint(data, tests::rubber_on_diamond()); }

class FitCoverage : public testing::TestWithParam<Case> {};

TEST_P(FitCoverage, OfEveryRouteMatchesItsIntervals) {
    const Case& run = GetParam();
    constexpr int seeds = 40;
    const BranchData truth = tests::branch_of(lens, run.shape, 1000);
    int modulus = 0, work = 0, converged = 0;
    setae::tests::Pulls modulus_pulls, work_pulls;
    double modulus_bias = 0.0, work_bias = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        const JkrFit fit = run.fit(tests::in_contact(tests::noisy(truth, run.signal_to_noise, generator)));
        converged += fit.converged;
        modulus += tests::covers(fit.contact_modulus, lens.contact_modulus);
        work += tests::covers(fit.work_of_adhesion, lens.work_of_adhesion);
        modulus_pulls.add(fit.contact_modulus, lens.contact_modulus);
        work_pulls.add(fit.work_of_adhesion, lens.work_of_adhesion);
        modulus_bias += (fit.contact_modulus.value - lens.contact_modulus) / fit.contact_modulus.standard_error / seeds;
        work_bias += (fit.work_of_adhesion.value - lens.work_of_adhesion) / fit.work_of_adhesion.standard_error / seeds;
    }
    EXPECT_EQ(converged, seeds);
    // 38 of 40 expected, standard deviation 1.4
    EXPECT_GE(modulus, 34);
    EXPECT_GE(work, 34);
    expect_honest(modulus_pulls, "E*");
    expect_honest(work_pulls, "W");
    // mean of 40 numbers of standard deviation 1: ± 0.16
    EXPECT_NEAR(modulus_bias, 0.0, 0.5);
    EXPECT_NEAR(work_bias, 0.0, 0.5);
}

std::vector<Case> cases() {
    struct Named {
        const char* name;
        JkrFit (*fit)(const BranchData&);
    };
    std::vector<Case> all;
    for (const Named& route : {Named{"effective_variance", effective_variance},
                               Named{"force_displacement", force_displacement}, Named{"joint", joint}})
        for (const auto shape : {BranchShape::loading, BranchShape::unloading})
            for (const double ratio : {5.0, 10.0, 30.0, 100.0}) all.push_back({route.name, route.fit, shape, ratio});
    return all;
}

std::string name_of(const testing::TestParamInfo<Case>& run) {
    return std::string(run.param.name) + (run.param.shape == BranchShape::loading ? "_loading_" : "_unloading_") +
           std::to_string(static_cast<int>(run.param.signal_to_noise));
}

INSTANTIATE_TEST_SUITE_P(Routes, FitCoverage, testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace setae::loops::fit_coverage_test
