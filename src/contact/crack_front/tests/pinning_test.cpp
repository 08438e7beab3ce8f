// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/pinning.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
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
TEST(Pinning, EquivalentWorkHasTheTheoreticalScatterAndMean) {
    const auto intensity = rough();
    const double W = 100.0 * intensity.stored_energy;
    const auto linear = equivalent_work(intensity.values, intensity.points, W, 1.0);
    const auto quadratic = equivalent_work(intensity.values, intensity.points, W, 1.0, EquivalentWork::quadratic);
    EXPECT_NEAR(linear.works.mean(), W, 1e-12 * W);
    EXPECT_NEAR(std::sqrt((linear.works - W).square().mean()) / W, 0.2, 1e-12);
    EXPECT_NEAR(quadratic.works.mean() - W, intensity.stored_energy, 1e-10 * W);
}

TEST(Pinning, WarnsWhereTheModelIsInvalid) {
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

TEST(Pinning, MeanWavelengthFollowsFromHeightAndStoredEnergy) {
    const auto spectrum = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / 32.0, 0.8, 2.0 * pi / 8.0});
    const auto map = synthesis::random_surface(spectrum, {128, 128, 128.0, 128.0}, {.key = {2}});
    const auto intensity = stress_intensity_on_parallels(map, {1.0, 2.0, {}});
    const double height = std::sqrt((map.heights - map.heights.mean()).square().mean());
    EXPECT_NEAR(mean_wavelength(height, intensity.stored_energy), intensity.mean_wavelength, 1e-6 * 32.0);
    EXPECT_THROW((void)mean_wavelength(0.0, 1.0), InvalidArgument);
}

// q_κ of G(a, δ) = E*(δ − a²/R)²/(2πa) by differences, on the equilibrium G = W
TEST(Pinning, RestoringStiffnessFollowsFromEnergyReleaseRate) {
    const contact::AdhesiveContact contact{1e-3, 1e6, 0.05};
    const auto release_rate = [&](double a, double displacement) {
        const double opening = displacement - a * a / contact.radius;
        return contact.contact_modulus * opening * opening / (2.0 * pi * a);
    };
    for (const double force : {0.0, 1e-4, 1e-3, -1e-4}) {
        const double a = contact::jkr::contact_radius_at_force(force, contact),
                     displacement = contact::jkr::displacement_at_force(force, contact), step = 1e-6 * a;
        EXPECT_NEAR(release_rate(a, displacement), 0.05, 1e-10);
        const double restoring =
            (release_rate(a + step, displacement) - release_rate(a - step, displacement)) / (2.0 * step * 0.05);
        EXPECT_NEAR(free_length(a, contact) * restoring / pi, 1.0, 1e-6);
    }
    const double at_rest = contact::jkr::contact_radius_at_force(0.0, contact),
                 at_load = contact::jkr::pull_off_at_fixed_load(contact).contact_radius,
                 at_grips = contact::jkr::pull_off_at_fixed_grips(contact).contact_radius;
    EXPECT_NEAR(free_length(at_rest, contact) / (2.0 * pi * at_rest), 0.1, 1e-9);
    EXPECT_NEAR(free_length(at_load, contact) / (2.0 * pi * at_load), 0.25, 1e-9);
    EXPECT_DOUBLE_EQ(free_length(at_grips, contact), 2.0 * pi * at_grips);
    EXPECT_THROW((void)free_length(0.0, contact), InvalidArgument);
}

// polished nanodiamond of Dalvi et al. 2019 on 0.7 MPa: h_rms 4.6 nm, U_el/(AE*) 0.177 nm, R = 1.25 mm, at 1 mN
TEST(Pinning, CountsLarkinLengthsOfAPublishedContact) {
    const double modulus = 0.91999923e6, gain = 0.037 * 1.07125 - 0.025 * 0.07125, stored = 0.177e-9;
    const contact::AdhesiveContact contact{1.25e-3, modulus, gain};
    const double share = stored * modulus / gain;
    EXPECT_NEAR(share, 0.0043, 5e-5);
    EXPECT_NEAR(larkin_lengths(contact::jkr::contact_radius_at_force(1e-3, contact), contact,
                               mean_wavelength(4.6e-9, stored), share),
                4.4, 0.05);
}

}  // namespace pinning_test
