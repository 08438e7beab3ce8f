// SPDX-License-Identifier: GPL-3.0-or-later
// The test of predictions on residuals whose χ² is known.
#include <gtest/gtest.h>

#include <cmath>

#include "setae/adhesion/prediction_test.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion::prediction_test_test {
namespace {

std::vector<PredictionResidual> pairs_of(const Array1D& measured, const Array1D& predicted) {
    std::vector<PredictionResidual> pairs;
    for (Index i = 0; i < measured.size(); ++i) pairs.push_back({"S", "E", {measured[i]}, {predicted[i]}});
    return pairs;
}

TEST(PredictionTest, OfIndependentErrorsIsTheSumOfSquares) {
    const Array1D measured{{3.0, 5.0, 4.0}}, predicted{{2.0, 5.0, 6.0}};
    Array2D covariance = Array2D::Zero(3, 3);
    covariance(0, 0) = 1.0, covariance(1, 1) = 4.0, covariance(2, 2) = 4.0;
    const auto test = prediction_test(pairs_of(measured, predicted), covariance, std::nullopt);
    EXPECT_NEAR(test.chi_squared, 2.0, 1e-12);
    EXPECT_EQ(test.degrees_of_freedom, 3);
    EXPECT_EQ(test.extra_scatter, 0.0);
    EXPECT_NEAR(test.pairs[2].standardised(), -1.0, 1e-12);
}

TEST(PredictionTest, OfAFittedWorkRemovesOneDegreeOfFreedom) {
    // all residuals alike are what another W_int explains
    const Array1D measured{{2.0, 3.0, 4.0}}, predicted{{1.0, 2.0, 3.0}}, slopes = Array1D::Ones(3);
    const Array2D covariance = Eigen::MatrixXd::Identity(3, 3).array();
    const auto test = prediction_test(pairs_of(measured, predicted), covariance, slopes);
    EXPECT_NEAR(test.chi_squared, 0.0, 1e-12);
    EXPECT_EQ(test.degrees_of_freedom, 2);
    EXPECT_NEAR(prediction_test(pairs_of(measured, predicted), covariance, std::nullopt).chi_squared, 3.0, 1e-12);
}

TEST(PredictionTest, ExtraScatterBringsChiSquaredToTheDegreesOfFreedom) {
    const Array1D measured{{4.0, -3.0, 5.0, -2.0}}, predicted = Array1D::Zero(4);
    const Array2D covariance = Eigen::MatrixXd::Identity(4, 4).array();
    const auto test = prediction_test(pairs_of(measured, predicted), covariance, std::nullopt);
    EXPECT_NEAR(test.chi_squared, 54.0, 1e-12);
    // 54/(1 + τ²) = 4
    EXPECT_NEAR(test.extra_scatter, std::sqrt(12.5), 1e-9);
    EXPECT_NEAR(test.chi_squared_with_scatter, 4.0, 1e-9);
    EXPECT_LT(test.probability, 1e-9);
    EXPECT_GT(test.probability_with_scatter, 0.3);
}

TEST(PredictionTest, RefusesDataWithoutDegreesOfFreedom) {
    const Array1D one = Array1D::Ones(1);
    EXPECT_THROW((void)prediction_test(pairs_of(one, one), Array2D::Ones(2, 2), std::nullopt), InvalidArgument);
    EXPECT_THROW((void)prediction_test(pairs_of(one, one), Array2D::Ones(1, 1), one), InvalidArgument);
    EXPECT_THROW((void)prediction_test(pairs_of(one, one), Array2D::Zero(1, 1), std::nullopt), UndefinedDataError);
}

}  // namespace
}  // namespace setae::adhesion::prediction_test_test
