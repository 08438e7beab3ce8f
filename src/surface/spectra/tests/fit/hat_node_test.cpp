// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/hat_node.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "setae/core/constants.hpp"

namespace hat_node_test {

using namespace setae;
using namespace setae::spectral_fit;

constexpr double h = node_spacing;

double integral(const std::function<double(double)>& f, double from, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, from, to, 4, 1e-10);
}

TEST(HatNode, AutocovarianceIsTheHankelTransformOfTheHat) {
    for (const double z : {0.0, 0.03, 0.7, 0.99, 1.01, 2.4, 17.3, 143.7, 1200.3, 2900.0}) {
        const auto lower = integral([&](double u) { return (1.0 + u / h) * ::j0(z * std::exp(u)); }, -h, 0.0);
        const auto upper = integral([&](double u) { return (1.0 - u / h) * ::j0(z * std::exp(u)); }, 0.0, h);
        EXPECT_NEAR(hat_node::autocovariance(z), lower + upper, 3e-7 * h) << z;
        EXPECT_NEAR(hat_node::autocovariance_of_lower_half(z), lower, 3e-6 * h) << z;
    }
    EXPECT_EQ(hat_node::autocovariance(3001.0), 0.0);
}

TEST(HatNode, AutocovarianceAtZeroIsTheVariance) {
    EXPECT_NEAR(hat_node::autocovariance(0.0), h, 1e-12);
    EXPECT_NEAR(hat_node::autocovariance_of_lower_half(0.0), 0.5 * h, 1e-12);
    EXPECT_NEAR(hat_node::autocovariance_of_disc(0.0), 0.5, 1e-12);
    EXPECT_NEAR(hat_node::autocovariance_of_disc(2.0), 0.5767248077568734 / 2.0, 1e-12);  // J1(2)/2
}

TEST(HatNode, LineIntegralsMatchTheAbelIntegral) {
    // midpoint sums over p of C(p) p/√(p² − q²), q on midpoints as well
    const auto density = [](double q) {
        constexpr int pieces = 2000;
        double sum = 0.0;
        const double end = std::sqrt(std::max(0.0, std::exp(2.0 * h) - q * q));
        for (int i = 0; i < pieces; ++i) {
            const double p = std::hypot(q, end * (i + 0.5) / pieces);  // v = √(p² − q²)
            sum += std::max(0.0, 1.0 - std::abs(std::log(p)) / h) / (p * p);
        }
        return sum * end / pieces / pi;
    };
    for (const double q : {0.2, 0.9, 0.97, 1.0, 1.03, 1.2}) {
        constexpr int pieces = 1000;
        double zeroth = 0.0, first = 0.0;
        for (int i = 0; i < pieces; ++i) {
            const double p = q * (i + 0.5) / pieces, value = density(p) * q / pieces;
            zeroth += value;
            first += value * p;
        }
        const auto found = hat_node::line_integrals(q);
        EXPECT_NEAR(found.zeroth, zeroth, 2e-4 * h) << q;
        EXPECT_NEAR(found.first, first, 2e-4 * h) << q;
    }
}

TEST(HatNode, WholeLineIntegralIsPiTimesTheVariance) {
    // (1/π) ∫ C1D dq = R(0) = h/2π
    EXPECT_NEAR(hat_node::line_integrals(3.0).zeroth / pi, h / (2.0 * pi), 1e-12);
    EXPECT_NEAR(hat_node::line_integrals_of_lower_half(3.0).zeroth / pi, 0.5 * h / (2.0 * pi), 1e-12);
    EXPECT_NEAR(hat_node::line_integrals_of_disc(3.0).zeroth / pi, 0.5 / (2.0 * pi), 1e-12);
}

}  // namespace hat_node_test
