// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "setae/loops/jkr_fits.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::correlated_residuals_test {
namespace {

using contact::jkr::Contact;

constexpr Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
constexpr int samples = 400;

BranchData branch() {
    BranchData data;
    data.force = Array1D::LinSpaced(samples, 0.8 * contact::jkr::pull_off_at_fixed_load(lens).force, 1e-3);
    data.contact_radius = contact::jkr::contact_radius_at_force(data.force, lens);
    data.displacement = contact::jkr::displacement_at_force(data.force, lens);
    return data;
}

/// Noise of given deviation whose neighbours correlate: x_i = φ x_(i−1) + √(1 − φ²) σ n_i.
Array1D correlated_noise(double neighbours, double sigma, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    Array1D noise(samples);
    double at = normal(generator);
    for (double& value : noise) {
        value = sigma * at;
        at = neighbours * at + std::sqrt(1.0 - neighbours * neighbours) * normal(generator);
    }
    return noise;
}

struct Coverage {
    double modulus = 0.0, work = 0.0;
    double correlated_samples = 0.0;  ///< mean over the fits
};

using Fit = std::function<JkrFit(const BranchData&)>;

/// Coverage of 95 % intervals with noise in radius and displacement.
Coverage coverage(double neighbours, const Fit& fit) {
    constexpr int seeds = 200;
    Coverage result;
    const BranchData clean = branch();
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        BranchData data = clean;
        data.contact_radius += correlated_noise(neighbours, 2e-7, generator);
        data.displacement += correlated_noise(neighbours, 5e-9, generator);
        const JkrFit found = fit(data);
        const auto covers = [](const Estimate& estimate, double truth) {
            const auto interval = interval_of(estimate);
            return interval->lower < truth && truth < interval->upper;
        };
        result.modulus += covers(found.contact_modulus, lens.contact_modulus) / static_cast<double>(seeds);
        result.work += covers(found.work_of_adhesion, lens.work_of_adhesion) / static_cast<double>(seeds);
        result.correlated_samples += found.correlated_samples / seeds;
    }
    return result;
}

// 200 fits: the share found scatters by √(0.95 · 0.05/200) = 1.5 %; 90 … 98 % is wanted
void expect_honest(const Coverage& found) {
    EXPECT_GE(found.modulus, 0.90);
    EXPECT_LE(found.modulus, 0.98);
    EXPECT_GE(found.work, 0.90);
    EXPECT_LE(found.work, 0.98);
}

const auto radius_force = [](const BranchData& data) { return fit_radius_force(data, tests::rubber_on_diamond()); };
const auto force_displacement = [](const BranchData& data) {
    return fit_force_displacement(data, tests::rubber_on_diamond());
};

TEST(CorrelatedResiduals, DoNotChangeIntervalsForIndependentNoise) {
    const auto found = coverage(0.0, radius_force);
    expect_honest(found);
    EXPECT_NEAR(found.correlated_samples, 1.0, 0.2);
}

TEST(CorrelatedResiduals, WidenIntervalsToTheStatedCoverage) {
    // τ = (1 + φ)/(1 − φ); of 200 records of 44 independent samples, less what the corrections leave
    const auto found = coverage(0.8, radius_force);
    expect_honest(found);
    EXPECT_NEAR(found.correlated_samples, 9.0, 1.5);
}

TEST(CorrelatedResiduals, WidenIntervalsFromDepth) { expect_honest(coverage(0.8, force_displacement)); }

TEST(CorrelatedResiduals, ReduceTheDegreesOfFreedom) {
    std::mt19937_64 generator(1);
    BranchData data = branch();
    data.contact_radius += correlated_noise(0.9, 2e-7, generator);
    const JkrFit fit = radius_force(data);
    EXPECT_EQ(fit.work_of_adhesion.method, "fit covariance, correlated residuals");
    EXPECT_LT(*fit.work_of_adhesion.degrees_of_freedom, samples / 8.0);
    EXPECT_NEAR(*fit.work_of_adhesion.degrees_of_freedom, samples / fit.correlated_samples - 2.0, 1e-9);
}

TEST(CorrelatedResiduals, OfFewSamplesAreTreatedAsIndependent) {
    // seven samples hold no estimate of a correlation: the textbook's covariance and n − p degrees of freedom
    BranchData data = branch();
    for (Array1D* series : {&data.force, &data.contact_radius, &data.displacement}) *series = Array1D(series->tail(7));
    data.contact_radius[3] *= 1.001;
    const JkrFit fit = radius_force(data);
    EXPECT_EQ(*fit.work_of_adhesion.degrees_of_freedom, 5.0);
    EXPECT_EQ(fit.correlated_samples, 1.0);
}

}  // namespace
}  // namespace setae::loops::correlated_residuals_test
