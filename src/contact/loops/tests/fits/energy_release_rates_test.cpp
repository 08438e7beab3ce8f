// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "noisy_branch.hpp"
#include "setae/loops/jkr_fits.hpp"

namespace setae::loops::energy_release_rates_test {
namespace {

using tests::branch_of;
using tests::BranchShape;

constexpr contact::jkr::Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};

/// 4000 repeats of one point: the scatter of G is the band.
TEST(EnergyReleaseRates, ScatterByTheirStandardError) {
    constexpr Index repeats = 4000;
    for (const bool measured : {true, false})
        for (const double shared : {0.0, -0.6}) {
            const BranchData one = branch_of(lens, BranchShape::loading, 10);
            BranchData data;
            data.force = Array1D::Constant(repeats, one.force[6]);
            data.displacement = Array1D::Constant(repeats, one.displacement[6]);
            if (measured) data.contact_radius = Array1D::Constant(repeats, one.contact_radius[6]);
            data.force_noise = 2e-6;
            data.displacement_noise = 2e-8;
            data.contact_radius_noise = measured ? 2e-7 : 0.0;
            data.force_displacement_covariance = shared * data.force_noise * data.displacement_noise;
            std::mt19937_64 generator(7);
            std::normal_distribution<double> normal;
            for (Index i = 0; i < repeats; ++i) {
                const double common = normal(generator);
                data.force[i] += data.force_noise * common;
                data.displacement[i] +=
                    data.displacement_noise * (shared * common + std::sqrt(1.0 - shared * shared) * normal(generator));
                if (measured) data.contact_radius[i] += data.contact_radius_noise * normal(generator);
            }
            const EnergyReleaseRate rates =
                energy_release_rates(data, lens.radius, {.value = lens.contact_modulus, .standard_error = 0.0},
                                     {.value = tests::contact_point, .standard_error = 0.0});
            const double mean = rates.energy_release_rate.mean();
            const double scatter = std::sqrt((rates.energy_release_rate - mean).square().mean());
            // the standard deviation of a standard deviation of 4000 numbers is 1.1 % of it
            EXPECT_NEAR(scatter / rates.standard_error.mean(), 1.0, 0.045) << measured << shared;
            EXPECT_EQ(rates.systematic.maxCoeff(), 0.0);
        }
}

TEST(EnergyReleaseRates, ShiftTogetherByTheirSystematicError) {
    for (const bool measured : {true, false}) {
        BranchData data = branch_of(lens, BranchShape::loading, 20);
        if (!measured) data.contact_radius = Array1D();
        const auto at = [&](double modulus, double point) {
            return energy_release_rates(data, lens.radius, {.value = modulus, .standard_error = 1e3},
                                        {.value = point, .standard_error = 1e-9});
        };
        const auto change = [](const EnergyReleaseRate& high, const EnergyReleaseRate& low) -> Array1D {
            return 0.5 * (high.energy_release_rate - low.energy_release_rate);
        };
        const double modulus = lens.contact_modulus, point = tests::contact_point;
        const Array1D by_modulus = change(at(modulus + 1e3, point), at(modulus - 1e3, point));
        const Array1D by_point = change(at(modulus, point + 1e-9), at(modulus, point - 1e-9));
        const Array1D expected = (by_modulus.square() + by_point.square()).sqrt();
        // central differences err by the square of the relative steps, 1e-6 and, near the jump-in, 1e-5
        EXPECT_LT((at(modulus, point).systematic / expected - 1.0).abs().maxCoeff(), 1e-4) << measured;
        EXPECT_EQ(by_point.abs().maxCoeff() == 0.0, measured);
    }
}

TEST(EnergyReleaseRates, HaveNoErrorIfTheNoiseIsUnknown) {
    BranchData data = branch_of(lens, BranchShape::loading, 5);
    data.force_noise = 1e-6;
    const EnergyReleaseRate rates = energy_release_rates(data, lens.radius, lens.contact_modulus, tests::contact_point);
    EXPECT_TRUE(rates.standard_error.isNaN().all());
    EXPECT_TRUE(rates.systematic.isNaN().all());
}

}  // namespace
}  // namespace setae::loops::energy_release_rates_test
