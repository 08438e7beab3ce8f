// SPDX-License-Identifier: GPL-3.0-or-later
// Maps that take more memory than may be used are read by bands of scan lines, with the same numbers.
#include <gtest/gtest.h>

#include <filesystem>

#include "setae/formats/npy.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::study::large_map_test {
namespace {

constexpr Index nx = 200, ny = 150;

class LargeMap : public testing::Test {
protected:
    void SetUp() override {
        const auto map =
            synthesis::random_surface(spectra::density({1e-28, 1e7, 0.8, 1e9}), {nx, ny, 1e-6, 0.75e-6}, {.key = {5}});
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = std::filesystem::temp_directory_path() / ("setae_large_map_" + test);  // tests run side by side
        std::filesystem::create_directories(folder);
        input.file = (folder / "map.npy").string();
        input.size = std::vector{1e-6, 0.75e-6};
        input.unit = "nm";
        input.instrument = "afm";
        input.tip_radius = Estimate{2e-8, 5e-9, "given"};
        formats::write_npy(input.file, Array2D(map.heights * 1e9));
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    MeasurementResult analysed(std::uint64_t largest_map) const {
        SurfaceAnalysisOptions options;
        options.spectrum = SpectrumMethod::average;
        options.largest_map = largest_map;
        return analyse_surface({.name = "A", .measurements = {input}}, options, {2}).measurements.at(0);
    }

    std::filesystem::path folder;
    MeasurementInput input;
};

TEST_F(LargeMap, HasTheResultsOfTheWholeMap) {
    const auto whole = analysed(std::uint64_t{1} << 30), tiled = analysed(nx * 16 * sizeof(double));
    ASSERT_EQ(whole.error, "");
    ASSERT_EQ(tiled.error, "");
    EXPECT_EQ(tiled.trend, whole.trend);
    EXPECT_EQ(tiled.name, whole.name);
    EXPECT_NEAR(tiled.real_space.rms_height, whole.real_space.rms_height, 1e-10 * whole.real_space.rms_height);
    EXPECT_NEAR(tiled.real_space.rms_curvature, whole.real_space.rms_curvature, 1e-10 * whole.real_space.rms_curvature);
    EXPECT_LT(((tiled.spectrum.density - whole.spectrum.density) / whole.spectrum.density).abs().maxCoeff(), 1e-8);
    EXPECT_NEAR(tiled.spectrum.band.upper, whole.spectrum.band.upper, 1e-6 * whole.spectrum.band.upper);
    ASSERT_TRUE(whole.bands_of_uncertain_tip && tiled.bands_of_uncertain_tip);
    for (const std::size_t side : {0, 1})
        EXPECT_NEAR((*tiled.bands_of_uncertain_tip)[side].upper, (*whole.bands_of_uncertain_tip)[side].upper,
                    1e-6 * whole.spectrum.band.upper);
    EXPECT_LT((tiled.preview.map - whole.preview.map).abs().maxCoeff(), 1e-12 * whole.real_space.rms_height / 1e-9);
}

TEST_F(LargeMap, ReportsThatItWasReadByBands) {
    const auto tiled = analysed(nx * 16 * sizeof(double));
    ASSERT_FALSE(tiled.alerts.empty());
    EXPECT_EQ(tiled.alerts.front().code, "LARGE_MAP");
    EXPECT_FALSE(tiled.slopes);
    EXPECT_FALSE(tiled.triangulated);
}

}  // namespace
}  // namespace setae::study::large_map_test
