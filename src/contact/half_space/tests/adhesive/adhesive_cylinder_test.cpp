// SPDX-License-Identifier: GPL-3.0-or-later
// A cylinder under constant tension of finite range: Baney, Hui, J. Adhes. Sci. Technol. 11 (1997) 393.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/half_space/adhesive_loop.hpp"

namespace setae::half_space::adhesive_cylinder_test {
namespace {

/// Load of a half width of contact a, in units a_0 = 2 (w R²/πE*)^(1/3) and P_0 = (π E* w² R)^(1/3) per length:
///   1 = λa²/2 (m s − ln(m + s)) + λ²a/2 (s ln(m + s) − m ln m),  s = √(m² − 1);   P = a² − λ a s
/// λ = 4σ (R/π²E*²w)^(1/3). To JKR's a² − 2√a as λ grows.
double load(double a, double lambda) {
    const auto excess = [&](double m) {
        const double s = std::sqrt(m * m - 1.0), log = std::log(m + s);
        return 0.5 * lambda * a * a * (m * s - log) + 0.5 * lambda * lambda * a * (s * log - m * std::log(m)) - 1.0;
    };
    double inner = 1.0, outer = 2.0;
    while (excess(outer) < 0.0) outer *= 2.0;
    while (outer - inner > 1e-13 * outer) {
        const double middle = 0.5 * (inner + outer);
        (excess(middle) < 0.0 ? inner : outer) = middle;
    }
    return a * a - lambda * a * std::sqrt(inner * inner - 1.0);
}

double pull_off(double lambda) {
    double least = 0.0;
    for (double a = 1e-4; a < 2.0; a *= 1.002) least = std::min(least, load(a, lambda));
    return -least;
}

TEST(BaneyHui, TendsToJkr) {
    EXPECT_NEAR(load(1.3, 1e4), 1.3 * 1.3 - 2.0 * std::sqrt(1.3), 1e-3);
    EXPECT_NEAR(pull_off(1e4), 1.5 * std::cbrt(0.5), 1e-3);
}

/// The greatest tension of a cylinder of R = E* = 1 in a periodic line, a_0 = 1.
double greatest_pull(Index points, double period, double lambda) {
    const double work = pi / 8.0, unit = pi / 4.0, tension = 0.5 * lambda * unit,
                 step = period / static_cast<double>(points);
    const Array2D heights = Array2D::NullaryExpr(1, points, [&](Index, Index j) {
        const double x = step * static_cast<double>(j - points / 2);
        return -0.5 * x * x;
    });
    AdhesiveCell cell(heights, {1, points, 1.0, period}, {.contact_modulus = 1.0},
                      {work, work / tension, AttractionLaw::dugdale});
    const auto loop = adhesive_loop(cell, {.max_pressure = 0.5 * unit / period});
    EXPECT_TRUE(loop.complete);
    double greatest = 0.0;
    for (const auto& step_of : loop.steps) greatest = std::max(greatest, step_of.state.tension);
    return greatest * period / unit;
}

// A tension that ends at once is caught by the pixel its end moves over: errors fall with the pixel
TEST(AdhesiveCylinder, PullOffMatchesBaneyAndHui) {
    for (const double lambda : {0.5, 1.0, 2.0})
        EXPECT_NEAR(greatest_pull(8192, 64.0, lambda) / pull_off(lambda), 1.0, 0.01) << lambda;
    const auto error = [](Index points) { return greatest_pull(points, 64.0, 1.0) / pull_off(1.0) - 1.0; };
    const double order = 0.5 * std::log2(error(1024) / error(4096));
    EXPECT_GT(order, 0.6);
    EXPECT_LT(order, 1.6);
}

}  // namespace
}  // namespace setae::half_space::adhesive_cylinder_test
