// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/pinning.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace pinning_test {

using namespace setae;
using namespace setae::crack_front;

StressIntensity rough() {
    const auto spectrum = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / 32.0, 0.8, 2.0 * pi / 8.0});
    return stress_intensity_on_parallels(synthesis::random_surface(spectrum, {128, 128, 128.0, 128.0}, {.key = {2}}),
                                         {1.0, 8.0, {}});
}

// std w/W = 2 √(U/W) = 0.2 at 0.01, mean of the quadratic field W + U
TEST(Pinning, OfTheEquivalentWorkHasTheScatterAndMeanOfTheory) {
    const auto intensity = rough();
    const double W = 100.0 * intensity.stored_energy;
    const auto linear = equivalent_work(intensity.values, intensity.points, W, 1.0);
    const auto quadratic = equivalent_work(intensity.values, intensity.points, W, 1.0, EquivalentWork::quadratic);
    EXPECT_NEAR(linear.works.mean(), W, 1e-12 * W);
    EXPECT_NEAR(std::sqrt((linear.works - W).square().mean()) / W, 0.2, 1e-12);
    EXPECT_NEAR(quadratic.works.mean() - W, intensity.stored_energy, 1e-10 * W);
}

TEST(Pinning, SaysWhatAFrontRestsOn) {
    const auto intensity = rough();
    const double U = intensity.stored_energy, length = intensity.mean_wavelength;
    const auto good = validity_of(intensity, 50.0 * U, 100.0 * length, 1.0);
    EXPECT_TRUE(good.cautions.empty());
    EXPECT_NEAR(good.work_scatter, 2.0 * std::sqrt(0.02), 1e-12);
    EXPECT_NEAR(good.larkin_length, length / 0.08, 1e-9);
    EXPECT_DOUBLE_EQ(good.points_per_wave, 8.0);
    EXPECT_EQ(validity_of(intensity, 50.0 * U, 5.0 * length, 1.0).cautions.size(), 1U);    // short
    EXPECT_EQ(validity_of(intensity, 10.0 * U, 100.0 * length, 1.0).cautions.size(), 1U);  // rough
    EXPECT_EQ(validity_of(intensity, 2.0 * U, 100.0 * length, 2.0).cautions.size(), 2U);   // too rough, coarse
    EXPECT_THROW((void)validity_of(intensity, 0.0, 1.0, 1.0), InvalidArgument);
    EXPECT_THROW((void)larkin_length(1.0, 0.0), InvalidArgument);
}

}  // namespace pinning_test
