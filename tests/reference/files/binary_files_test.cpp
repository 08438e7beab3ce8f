// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/channel.hpp"
#include "setae/io/whole_file.hpp"

// WSxM, Sensofar and Alicona files of instruments against another reader and against what their source publishes.
namespace setae::io {
namespace {

using topography::HeightMap;

nlohmann::json expected_entry(const std::string& file) {
    auto text = read_file((tests::reference_data_folder() / "expected" / "topography_files.json").string());
    for (auto at = text.find(": NaN"); at != std::string::npos; at = text.find(": NaN", at)) text.replace(at, 5, ": null");
    for (const auto& entry : nlohmann::json::parse(text))
        if (entry.at("file") == file) return entry;
    return nullptr;
}

/// Mean and standard deviation over defined heights.
struct Spread {
    double mean = 0.0, deviation = 0.0;
    Index undefined = 0;
};

Spread spread(const Array2D& heights) {
    Spread result;
    result.undefined = heights.isNaN().count();
    const auto defined = static_cast<double>(heights.size() - result.undefined);
    result.mean = heights.isNaN().select(0.0, heights).sum() / defined;
    result.deviation = std::sqrt(heights.isNaN().select(0.0, heights - result.mean).square().sum() / defined);
    return result;
}

/// `factor`: metres per unit of the entry.
void expect_entry(const HeightMap& map, const nlohmann::json& entry, double factor) {
    const auto& computed = entry.at("peer_computed");
    const auto found = spread(map.heights);
    EXPECT_EQ(map.shape(), (entry.at("shape").get<std::array<Index, 2>>()));
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(map.size[i] / factor / entry.at("physical_sizes").at(i).get<double>(), 1.0, 1e-9) << i;
    EXPECT_EQ(found.undefined, computed.at("n_undefined").get<Index>());
    EXPECT_NEAR(found.deviation / factor / computed.at("std_valid").get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(found.mean / factor / computed.at("mean_valid").get<double>(), 1.0, 1e-9);
    const auto corners = computed.at("corners_00_0m1_m10_m1m1").get<std::array<double, 4>>();
    const Index right = map.heights.rows() - 1, bottom = map.heights.cols() - 1;
    const std::array<double, 4> ours{map.heights(0, 0), map.heights(0, bottom), map.heights(right, 0), map.heights(right, bottom)};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(ours[i] / factor / corners[i], 1.0, 1e-9) << i;
}

TEST(Wsxm, IntegersSpanTheAmplitudeOfTheHeader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/top-1.top");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    const auto map = std::get<HeightMap>(channels[0].read());
    expect_entry(map, expected_entry("topography/surfacetopography/top-1.top"), units::nm);
    EXPECT_NEAR(map.heights.maxCoeff() - map.heights.minCoeff(), 18.8851 * units::nm, 1e-15);
    // the instrument's own calibration: 21.2 nm at gain 3 for a DSP range of 20 V and 16 bits
    EXPECT_NEAR((map.heights.maxCoeff() - map.heights.minCoeff()) / 973.0, 21.2 * units::nm * 3.0 * 20.0 / 65536.0, 1e-5 * 0.0194 * units::nm);
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "03/11/2011, 20:23:46.484");
    EXPECT_EQ(channels[0].info.unit, "nm");
}

TEST(Wsxm, DoublesAreHeightsAsTheyStand) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/afmreader/sample_0.stp");
    const auto map = std::get<HeightMap>(read(path.string()));
    ASSERT_EQ(map.shape(), (std::array<Index, 2>{512, 512}));
    EXPECT_NEAR(map.heights.sum() / units::nm, -15070620.440757688, 1e-11 * 15070620.0);
    EXPECT_NEAR(map.pixel_size()[0] / units::nm, 0.9765625, 1e-12);
    EXPECT_NEAR(map.pixel_size()[1] / units::nm, 0.9765625, 1e-12);
    EXPECT_NEAR((map.heights.maxCoeff() - map.heights.minCoeff()) / units::nm, 59.7449, 1e-6) << "the Z amplitude of the header";
}

TEST(Sensofar, TopographyWithItsTime) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/plu-1.plu");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    expect_entry(std::get<HeightMap>(channels[0].read()), expected_entry("topography/surfacetopography/plu-1.plu"), units::um);
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "Fri Mar 10 16:35:59 2023");
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "PLu neox");
}

TEST(Alicona, DepthImage) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/al3d-1.al3d");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    expect_entry(std::get<HeightMap>(channels[0].read()), expected_entry("topography/surfacetopography/al3d-1.al3d"), units::m);
    EXPECT_EQ(channels[0].info.metadata.attributes.at("software_version"), "MeasureSuite 5.3.6");
}

TEST(NtMdt, ForceCurvesAsTextAreNoTopography) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "force_curves/fmt-ntmdt-txt-fd_2015_01_17_gel4-0,1_mQ_adh_6B_Curve_DFL_Height_51.txt");
    EXPECT_THROW((void)read(path.string()), Error) << "neither size nor unit stands in the file";
}

}  // namespace
}  // namespace setae::io
