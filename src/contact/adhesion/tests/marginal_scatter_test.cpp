// SPDX-License-Identifier: GPL-3.0-or-later
// Scatter integrated out: against the integral it stands for, and against itself at more nodes.
#include "setae/adhesion/marginal_scatter.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::adhesion::marginal_scatter_test {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

std::vector<PairLabels> square(int side) {
    std::vector<PairLabels> labels;
    for (int s = 0; s < side; ++s)
        for (int e = 0; e < side; ++e) labels.push_back({"s" + std::to_string(s), "e" + std::to_string(e)});
    return labels;
}

// One pair without errors of its own: the three levels add in squares, r ~ N(0, τ² + τ_s² + τ_e²). Many nodes against
// an integral over τ by a fine rule in p, τ = tan(π p/2), level by level.
TEST(MarginalScatter, OfOnePairEqualsTheIntegralOverItsScatter) {
    constexpr double r = 1.3, pi = 3.14159265358979;
    constexpr int n = 120;
    double sum = 0.0;
    const auto level = [](int i) { return std::tan(0.5 * pi * (i + 0.5) / n); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const double v = 0.01 + level(i) * level(i) + level(j) * level(j) + level(k) * level(k);
                sum += std::exp(-0.5 * r * r / v) / std::sqrt(2.0 * pi * v);
            }
    const MarginalScatter scatter({{"s", "e"}}, 1.0, {40, 40, 40});
    const auto found = scatter.log_densities(MatrixXd::Constant(1, 1, 0.01), MatrixXd::Constant(1, 1, r));
    EXPECT_NEAR(found[0], std::log(sum / n / n / n), 0.01);
}

TEST(MarginalScatter, ConvergesWithTheNumberOfNodes) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto labels = square(4);
    const MarginalScatter few(labels, 8.0), many(labels, 8.0, {24, 14, 14});
    const MatrixXd own = MatrixXd::Identity(16, 16) * 9.0;
    MatrixXd data(16, 20);
    for (int k = 0; k < 20; ++k) {
        const double by[3] = {3.0 * k / 4.0, 2.0 * (k % 5), 6.0 * (k % 3)};
        double surface[4], elastomer[4];
        for (int i = 0; i < 4; ++i) {
            surface[i] = by[1] * normal(random);
            elastomer[i] = by[2] * normal(random);
        }
        for (int i = 0; i < 16; ++i) data(i, k) = (3.0 + by[0]) * normal(random) + surface[i / 4] + elastomer[i % 4];
    }
    const VectorXd one = few.log_densities(own, data), other = many.log_densities(own, data);
    for (int k = 0; k < 20; ++k) EXPECT_NEAR(one[k], other[k], 0.3) << k;
}

// What all surfaces share is no scatter: sixteen residuals of 60 ± 3 are far likelier as a bias.
TEST(MarginalScatter, DistinguishesABiasFromScatter) {
    const auto labels = square(4);
    const MarginalScatter scatter(labels, 8.0);
    const MatrixXd own = MatrixXd::Identity(16, 16) * 9.0;
    VectorXd shifted = VectorXd::Constant(16, 60.0);
    std::mt19937 random(4);
    std::normal_distribution<double> normal(0.0, 3.0);
    for (auto& x : shifted) x += normal(random);
    const MatrixXd biased = own + MatrixXd::Constant(16, 16, 60.0 * 60.0);
    EXPECT_GT(scatter.log_densities(biased, shifted)[0], scatter.log_densities(own, shifted)[0] + 1.0);
}

TEST(MarginalScatter, RecoversTheTrueScatter) {
    const auto labels = square(8);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    VectorXd r(64);
    double surface[8];
    for (double& s : surface) s = 10.0 * normal(random);
    for (int i = 0; i < 64; ++i) r[i] = surface[i / 8] + 4.0 * normal(random);
    const auto found =
        MarginalScatter(labels, 8.0, {24, 14, 14}).posterior_scatter(MatrixXd::Identity(64, 64) * 1e-4, r);
    EXPECT_NEAR(found.pair, 4.0, 1.0);
    EXPECT_NEAR(found.surface, 10.0, 5.0);
    EXPECT_LT(found.elastomer, 3.0);
}

TEST(MarginalScatter, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW(MarginalScatter({}, 1.0), InvalidArgument);
    EXPECT_THROW(MarginalScatter({{"s", "e"}}, 0.0), InvalidArgument);
    const MarginalScatter scatter({{"s", "e"}}, 1.0);
    EXPECT_THROW((void)scatter.log_densities(MatrixXd::Constant(1, 1, -1e9), MatrixXd::Constant(1, 1, 1.0)),
                 UndefinedDataError);
}

}  // namespace
}  // namespace setae::adhesion::marginal_scatter_test
