// SPDX-License-Identifier: GPL-3.0-or-later
// Random self-affine surfaces with their exponents: A ∝ d^2H, bandwidth ∝ ℓ^H, slope ∝ d^(H−1), curvature ∝ d^(H−2),
// over seeds.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace self_affine_test {

using namespace setae;
using namespace setae::scales;

constexpr Index points = 512;

topography::HeightMap surface(double hurst, std::uint64_t seed) {
    const spectra::SelfAffine model{1.0, 2.0 * pi / static_cast<double>(points), hurst, pi};
    return synthesis::random_surface(spectra::density(model), {points, points, points, points}, {.key = {seed}});
}

/// Exponent of a mean over seeds between two distances, by a line through logarithms.
double exponent(const std::vector<FunctionOfScale>& functions, double lower, double upper) {
    Array1D mean = Array1D::Zero(functions[0].value.size());
    for (const auto& function : functions) mean += function.value.square();
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (Index k = 0; k < mean.size(); ++k) {
        const double d = functions[0].distance[k];
        if (d < lower || d > upper) continue;
        const double u = std::log(d), v = 0.5 * std::log(mean[k]);
        n += 1.0;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

TEST(SelfAffineSurfaces, HaveTheirExponentInEveryFunctionOfScale) {
    for (const double hurst : {0.4, 0.7}) {
        std::vector<FunctionOfScale> lines, area, bandwidth, bandwidth_area, slope, curvature;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const auto map = surface(hurst, seed);
            lines.push_back(autocorrelation_of_lines(map));
            area.push_back(autocorrelation_of_area(map));
            bandwidth.push_back(variable_bandwidth_along_lines(map));
            bandwidth_area.push_back(variable_bandwidth_of_area(map));
            slope.push_back(function_of(difference_statistics(map), Statistic::rms));
            curvature.push_back(
                function_of(difference_statistics(map, {.order = 2, .along = Along::both}), Statistic::rms));
        }
        // finite size bends the autocorrelation down where d nears the roll-off; the short end sees the pixels
        EXPECT_NEAR(exponent(lines, 4.0, 25.0), 2.0 * hurst, 0.1);
        EXPECT_NEAR(exponent(area, 4.0, 25.0), 2.0 * hurst, 0.1);
        EXPECT_NEAR(exponent(bandwidth, 16.0, 130.0), hurst, 0.05);
        EXPECT_NEAR(exponent(bandwidth_area, 16.0, 130.0), hurst, 0.05);
        EXPECT_NEAR(exponent(slope, 4.0, 25.0), hurst - 1.0, 0.05);
        EXPECT_NEAR(exponent(curvature, 8.0, 80.0), hurst - 2.0, 0.05);
    }
}

}  // namespace self_affine_test
