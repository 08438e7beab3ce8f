// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/model_spectra.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace model_spectra_test {

using namespace setae;
using namespace setae::spectra;

TEST(SoftCutoff, FallsToOneOverEOfThePowerLawAtItsCutoff) {
    const auto C_iso = density(SoftCutoff{3.0, 2.0, 0.5, 20.0});
    EXPECT_NEAR(C_iso(20.0), 3.0 * 1e-3 * std::exp(-1.0), 1e-17);
    EXPECT_NEAR(C_iso(1.0), 3.0 * std::exp(-1.0 / 400.0), 1e-15);
    EXPECT_NEAR(C_iso(60.0) / (3.0 * std::pow(30.0, -3.0) * std::exp(-9.0)), 1.0, 1e-14);
    EXPECT_EQ(C_iso(1000.0), 0.0);
}

TEST(TwoSlopes, MeetAtTheCrossover) {
    const auto C_iso = density(TwoSlopes{5.0, 1.0, 1.0, 10.0, 0.5, 100.0});
    EXPECT_EQ(C_iso(0.5), 5.0);
    EXPECT_NEAR(C_iso(10.0), 5e-4, 1e-18);
    EXPECT_NEAR(C_iso(9.999999) / C_iso(10.0), 1.0, 1e-6);
    EXPECT_NEAR(C_iso(5.0), 5.0 / 625.0, 1e-16);
    EXPECT_NEAR(C_iso(100.0), 5e-7, 1e-20);
    EXPECT_EQ(C_iso(101.0), 0.0);
}

TEST(Bump, IsALogNormalPeakOnTheBase) {
    const SelfAffine base{2.0, 1.0, 0.8, 1000.0};
    const auto C_iso = density(Bump{base, 4.0, 30.0, 0.2}), plain = density(base);
    EXPECT_NEAR(C_iso(30.0) / plain(30.0), 5.0, 1e-14);
    EXPECT_NEAR(C_iso(30.0 * std::exp(0.2)) / plain(30.0 * std::exp(0.2)), 1.0 + 4.0 * std::exp(-0.5), 1e-13);
    EXPECT_EQ(C_iso(0.0), 2.0);
    EXPECT_EQ(C_iso(1001.0), 0.0);
}

TEST(ModelSpectra, RefuseContradictoryParameters) {
    EXPECT_THROW((void)density(SoftCutoff{1.0, 2.0, 0.5, 1.0}), InvalidArgument);
    EXPECT_THROW((void)density(SoftCutoff{1.0, 2.0, 1.2, 4.0}), InvalidArgument);
    EXPECT_THROW((void)density(TwoSlopes{1.0, 1.0, 0.5, 200.0, 0.5, 100.0}), InvalidArgument);
    EXPECT_THROW((void)density(TwoSlopes{1.0, 1.0, 0.5, 10.0, 0.0, 100.0}), InvalidArgument);
    EXPECT_THROW((void)density(Bump{{1.0, 1.0, 0.5, 10.0}, -1.0, 2.0, 0.2}), InvalidArgument);
    EXPECT_THROW((void)density(Bump{{1.0, 1.0, 0.5, 10.0}, 1.0, 2.0, 0.0}), InvalidArgument);
}

}  // namespace model_spectra_test
