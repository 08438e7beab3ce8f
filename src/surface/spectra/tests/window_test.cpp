// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/window.hpp"

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/log_grid.hpp"

namespace window_test {

using namespace setae;
using namespace setae::spectra;

TEST(Window, KeepsThePowerForAnyNumberOfPoints) {
    for (const auto window : {Window::none, Window::hann, Window::blackman_harris})
        for (const Index n : {2, 3, 7, 64, 1001})
            EXPECT_NEAR(window_values(window, n).square().sum(), static_cast<double>(n),
                        1e-12 * static_cast<double>(n));
}

TEST(Window, HannIsOneMinusCosine) {
    const auto values = window_values(Window::hann, 8);
    for (Index j = 0; j < 8; ++j)
        EXPECT_NEAR(values[j], std::sqrt(2.0 / 3.0) * (1.0 - std::cos(2.0 * pi * static_cast<double>(j) / 8.0)), 1e-15);
}

TEST(Window, BlackmanHarrisNearlyVanishesAtItsEnds) {
    EXPECT_NEAR(window_values(Window::blackman_harris, 64)[0] / window_values(Window::blackman_harris, 64)[32], 6e-5,
                1e-12);
}

TEST(Window, AutomaticTapersNonPeriodicDataOnly) {
    EXPECT_EQ(resolved(Window::automatic, false), Window::hann);
    EXPECT_EQ(resolved(Window::automatic, true), Window::none);
    EXPECT_EQ(resolved(Window::none, false), Window::none);
}

TEST(Window, NamesConvertToWindowsAndBack) {
    for (const auto window :
         {Window::automatic, Window::none, Window::hann, Window::blackman_harris, Window::radial_hann})
        EXPECT_EQ(window_from_name(name(window)), window);
    EXPECT_THROW((void)window_from_name("hanning"), InvalidArgument);
}

TEST(Window, RadialRequiresTwoCoordinates) {
    EXPECT_THROW((void)window_values(Window::radial_hann, 8), InvalidArgument);
}

TEST(LogGrid, EdgesLieOnDecades) {
    const LogGrid grid;
    EXPECT_EQ(grid.edge(60), 1e6);
    EXPECT_EQ(grid.edge(-30), 1e-3);
    EXPECT_NEAR(grid.centre(60), std::sqrt(grid.edge(60) * grid.edge(61)), 1e-9);
}

TEST(LogGrid, PointsOnAnEdgeBelongToTheUpperBinDespiteRounding) {
    const LogGrid grid;
    for (Index bin = -120; bin <= 120; ++bin) {
        EXPECT_EQ(grid.bin_of(grid.edge(bin)), bin);
        EXPECT_EQ(grid.bin_of(grid.edge(bin) * (1.0 - 1e-15)), bin);
        EXPECT_EQ(grid.bin_of(grid.edge(bin) * (1.0 - 1e-9)), bin - 1);
        EXPECT_EQ(grid.bin_of(grid.centre(bin)), bin);
    }
}

TEST(LogGrid, RefusesNonPositiveWavevectors) {
    EXPECT_THROW((void)LogGrid{}.bin_of(0.0), InvalidArgument);
    EXPECT_THROW((void)LogGrid{}.bin_of(undefined), InvalidArgument);
}

}  // namespace window_test
