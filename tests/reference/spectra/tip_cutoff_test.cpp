// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/reliability.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/channel.hpp"

namespace tip_cutoff_test {

using namespace setae;
using spectra::tip_cutoff;
using topography::LineScan;
using topography::Profile;

TEST(TipCutoffOfRealFiles, AfmMapIs90Point700854Nanometres) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/di-1.di");
    EXPECT_NEAR(tip_cutoff(formats::read(path.string()), 40 * units::nm).value / (90.700854 * units::nm), 1.0, 1e-7);
}

/// The points of a two-column text in µm, with x as rounded as the file has it.
Profile points_as_written(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<double> x, h;
    for (std::string line; std::getline(file, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream columns(line);
        double position = 0.0, height = 0.0;
        if (!(columns >> position >> height)) continue;
        x.push_back(position * units::um);
        h.push_back(height * units::um);
    }
    const auto n = static_cast<Index>(x.size());
    return {Eigen::Map<Array1D>(x.data(), n), Eigen::Map<Array1D>(h.data(), n), {}};
}

TEST(TipCutoffOfRealFiles, LineScanIs126Point519Nanometres) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/xy-4.txt");
    const auto profile = points_as_written(path);
    const Index n = profile.positions.size();
    const LineScan scan{
        profile.heights, profile.size() * static_cast<double>(n) / static_cast<double>(n - 1), false, {}};
    EXPECT_NEAR(tip_cutoff(scan, 40 * units::nm).value / units::um, 0.126519, 1e-6);
    // as a polyline 0.126527 at the positions the package samples; the minimum over all x is a little sharper
    EXPECT_NEAR(tip_cutoff(profile, 40 * units::nm).value / units::um, 0.12653, 5e-6);
}

TEST(TipCutoffOfRealFiles, StylusScanIs1Point57Micrometres) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/dektak-1.csv");
    EXPECT_NEAR(tip_cutoff(points_as_written(path), 2.5 * units::um).value / (1.57 * units::um), 1.0, 0.01);
    EXPECT_NEAR(tip_cutoff(formats::read(path.string()), 2.5 * units::um).value / (1.57 * units::um), 1.0, 0.01);
}

}  // namespace tip_cutoff_test
