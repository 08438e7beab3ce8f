// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_sum.hpp"

#include <cmath>
#include <complex>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace nonuniform_test {

using namespace setae;
using fourier::nonuniform_transform;
using fourier::nonuniform_transform_by_sum;

Array1D random_array(Index n, double lower, double upper, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> number(lower, upper);
    return Array1D::NullaryExpr(n, [&] { return number(engine); });
}

Array1D log_spaced(Index n, double lower, double upper) {
    return Eigen::exp(Array1D::LinSpaced(n, std::log(lower), std::log(upper)));
}

/// The sum with phases in extended precision, without the rounding that both methods in double have.
std::complex<double> exact_sum(const Array1D& x, const Array1D& c, double q) {
    long double real = 0.0L, imaginary = 0.0L;
    for (Index k = 0; k < x.size(); ++k) {
        const long double phase = static_cast<long double>(q) * static_cast<long double>(x[k]);
        real += c[k] * std::cos(phase);
        imaginary -= c[k] * std::sin(phase);
    }
    return {static_cast<double>(real), static_cast<double>(imaginary)};
}

double largest_error(const Array1D& x, const Array1D& c, const Array1D& q) {
    const auto result = nonuniform_transform(x, c, q);
    double error = 0.0;
    for (Index j = 0; j < q.size(); ++j) error = std::max(error, std::abs(result[j] - exact_sum(x, c, q[j])));
    return error / c.abs().sum();
}

TEST(NonuniformTransform, MatchesTheSumTo1e13WherePhasesAreExact) {
    const auto x = random_array(3000, -1.0, 1.0, 1);
    const auto c = random_array(3000, -1.0, 1.0, 2);
    EXPECT_LT(largest_error(x, c, random_array(500, -400.0, 400.0, 3)), 1e-13);
}

TEST(NonuniformTransform, MatchesTheSumForPositiveCoefficients) {
    const auto x = random_array(3000, -1.0, 1.0, 1);
    EXPECT_LT(largest_error(x, Array1D::Ones(3000), random_array(500, -400.0, 400.0, 3)), 1e-13);
}

TEST(NonuniformTransform, ErrorIsPhaseRoundingOverFiveDecades) {
    const auto x = random_array(3000, 0.0, 1.0, 4);
    const auto c = random_array(3000, -1.0, 1.0, 5);
    EXPECT_LT(largest_error(x, c, log_spaced(300, 6.0, 6e5)), 1e-13 + 1.2e-16 * 6e5);
}

TEST(NonuniformTransform, EqualsTheDirectSumForFewTerms) {
    const auto x = random_array(7, 0.0, 1.0, 6);
    const auto c = random_array(7, -1.0, 1.0, 7);
    const auto q = log_spaced(9, 1.0, 1e4);
    EXPECT_EQ((nonuniform_transform(x, c, q) - nonuniform_transform_by_sum(x, c, q)).abs().maxCoeff(), 0.0);
}

TEST(NonuniformTransform, SplitsRangesTooWideForOneGrid) {
    // the grid of the whole range would need 2.5 million points
    const auto x = random_array(2000, 0.0, 1.0, 8);
    const auto c = random_array(2000, -1.0, 1.0, 9);
    const Array1D q = Array1D::LinSpaced(40000, 1.0, 8e6);
    const auto result = nonuniform_transform(x, c, q);
    for (Index j = 0; j < q.size(); j += 997)
        EXPECT_LT(std::abs(result[j] - exact_sum(x, c, q[j])), (1e-13 + 1.2e-16 * 8e6) * c.abs().sum());
}

TEST(NonuniformTransform, OfOnePointIsAPhaseFactor) {
    const Array1D x = Array1D::Constant(1, 0.25), c = Array1D::Constant(1, 2.0), q = Array1D::Constant(1, 3.0);
    EXPECT_LT(std::abs(nonuniform_transform(x, c, q)[0] - std::polar(2.0, -0.75)), 1e-15);
}

TEST(NonuniformTransform, AddsManyCoincidingPoints) {
    const Array1D x = Array1D::Constant(5000, 0.5), c = Array1D::Ones(5000), q = Array1D::Constant(5000, 2.0);
    EXPECT_LT(std::abs(nonuniform_transform(x, c, q)[7] - std::polar(5000.0, -1.0)), 5000.0 * 1e-13);
}

TEST(NonuniformTransform, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto x = random_array(3000, 0.0, 1.0, 10);
    const auto c = random_array(3000, -1.0, 1.0, 11);
    const auto q = log_spaced(2000, 6.0, 6e4);
    const auto one = nonuniform_transform(x, c, q, {1}), two = nonuniform_transform(x, c, q, {2});
    EXPECT_TRUE((one == two).all());
}

TEST(NonuniformTransform, RefusesUnequalSizesAndNaN) {
    EXPECT_THROW((void)nonuniform_transform(Array1D::Zero(3), Array1D::Zero(2), Array1D::Ones(1)), InvalidArgument);
    EXPECT_THROW((void)nonuniform_transform(Array1D::Zero(1), Array1D::Constant(1, NAN), Array1D::Ones(1)),
                 InvalidArgument);
}

}  // namespace nonuniform_test
