// SPDX-License-Identifier: GPL-3.0-or-later
// What a mixed model costs with the number of its rows, and that sums over groups are those of whole matrices.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include <Eigen/Core>
#include <Eigen/LU>

#include "allocated_bytes.hpp"
#include "nested_design.hpp"
#include "restricted_likelihood.hpp"
#include "setae/statistics/mixed_model.hpp"

namespace setae::statistics::growth_test {
namespace {

/// So many rows on a surface, five a lens; one level, a surface, where no lens is named.
ReplicateData rows_of(int n, bool lenses, int surfaces = 1) {
    ReplicateData data{.levels =
                           lenses ? std::vector<std::string>{"surface", "lens"} : std::vector<std::string>{"surface"}};
    std::mt19937_64 generator(7);
    std::normal_distribution<double> normal;
    double of_lens = 0.0;
    for (int i = 0; i < n; ++i) {
        if (i % 5 == 0) of_lens = normal(generator);
        Replicate row{.value = 50.0 + 2.0 * of_lens + normal(generator), .standard_error = 0.3 + 0.05 * (i % 4)};
        row.groups.push_back("surface " + std::to_string(i * surfaces / n));
        if (lenses) row.groups.push_back("lens " + std::to_string(i / 5));
        data.rows.push_back(std::move(row));
    }
    return data;
}

TEST(MixedModel, UsesMemoryInProportionToItsRows) {
    for (const bool lenses : {false, true}) {
        double before = 0.0;
        int fewer = 0;
        for (const int n : {100, 1000, 8000}) {  // lists that double hold 128, 1024, 8192
            const auto data = rows_of(n, lenses);
            const double bytes = tests::bytes_of([&] { (void)mixed_model(data, {.influence = false}); });
            if (before > 0.0) {
                EXPECT_LT(tests::exponent(fewer, before, n, bytes), 1.1) << n << " rows, lenses: " << lenses;
            }
            before = bytes;
            fewer = n;
        }
    }
}

// V, P and the information written out as matrices over all rows
TEST(MixedModel, SumsOverGroupsEqualFullMatrices) {
    const auto data = rows_of(40, true, 2);
    std::vector<std::size_t> all(data.rows.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const auto design = nested_design(data, all);
    ASSERT_EQ(design.levels.size(), 2u);
    const Array1D variances{{3.7, 0.9}};
    const auto found = information_of(design, variances);
    const Index n = design.size();
    const auto indicators = [&](const std::vector<int>& group, int groups) {
        Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(n, groups);
        for (Index i = 0; i < n; ++i) Z(i, group[static_cast<std::size_t>(i)]) = 1.0;
        return Z;
    };
    const Eigen::MatrixXd X = indicators(design.surface, 2);
    Eigen::MatrixXd V = design.known_variance.matrix().asDiagonal();
    std::vector<Eigen::MatrixXd> K;
    for (std::size_t k = 0; k < 2; ++k) {
        const auto Z = indicators(design.levels[k].group, design.levels[k].groups);
        K.emplace_back(Z * Z.transpose());
        V += variances[static_cast<Index>(k)] * K[k];
    }
    const Eigen::MatrixXd inverse = V.inverse(), phi = (X.transpose() * inverse * X).inverse(),
                          weights = phi * X.transpose() * inverse, P = inverse - inverse * X * weights;
    EXPECT_LT((found.row_weights - weights).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((found.means - weights * design.value.matrix()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((found.means_covariance - phi).cwiseAbs().maxCoeff(), 1e-13);
    Eigen::MatrixXd information(2, 2);
    for (Index j = 0; j < 2; ++j) {
        const auto& of_j = K[static_cast<std::size_t>(j)];
        EXPECT_LT(
            (found.gradients[static_cast<std::size_t>(j)] - weights * of_j * weights.transpose()).cwiseAbs().maxCoeff(),
            1e-14);
        for (Index k = 0; k < 2; ++k) information(j, k) = 0.5 * (P * of_j * P * K[static_cast<std::size_t>(k)]).trace();
    }
    const Eigen::MatrixXd covariance = information.inverse();
    EXPECT_LT((found.covariance.matrix() - covariance).cwiseAbs().maxCoeff(), 1e-12 * covariance.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace setae::statistics::growth_test
