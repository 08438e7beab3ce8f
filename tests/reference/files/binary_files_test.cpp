// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "expected_file.hpp"
#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"

// WSxM, Sensofar and Alicona files of instruments against another reader and against what their source publishes.
namespace setae::formats::binary_files_test {
namespace {

using topography::HeightMap;

TEST(Wsxm, IntegersSpanTheAmplitudeOfTheHeader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/top-1.top");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    const auto map = std::get<HeightMap>(channels[0].read());
    expect_entry_of(channels[0], expected_entry("topography/surfacetopography/top-1.top"), units::nm);
    EXPECT_NEAR(map.heights.maxCoeff() - map.heights.minCoeff(), 18.8851 * units::nm, 1e-15);
    // the instrument's own calibration: 21.2 nm at gain 3 for a DSP range of 20 V and 16 bits
    EXPECT_NEAR((map.heights.maxCoeff() - map.heights.minCoeff()) / 973.0, 21.2 * units::nm * 3.0 * 20.0 / 65536.0,
                1e-5 * 0.0194 * units::nm);
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "03/11/2011, 20:23:46.484");
    EXPECT_EQ(channels[0].info.unit, "nm");
}

TEST(Wsxm, DoublesAreHeightsWithoutScaling) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/afmreader/sample_0.stp");
    const auto map = std::get<HeightMap>(read(path.string()));
    ASSERT_EQ(map.shape(), (std::array<Index, 2>{512, 512}));
    EXPECT_NEAR(map.heights.sum() / units::nm, -15070620.440757688, 1e-11 * 15070620.0);
    EXPECT_NEAR(map.pixel_size()[0] / units::nm, 0.9765625, 1e-12);
    EXPECT_NEAR(map.pixel_size()[1] / units::nm, 0.9765625, 1e-12);
    EXPECT_NEAR((map.heights.maxCoeff() - map.heights.minCoeff()) / units::nm, 59.7449, 1e-6)
        << "the Z amplitude of the header";
}

TEST(Sensofar, HasTheExpectedTopographyAndTime) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/plu-1.plu");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    expect_entry_of(channels[0], expected_entry("topography/surfacetopography/plu-1.plu"), units::um);
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "Fri Mar 10 16:35:59 2023");
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "PLu neox");
}

TEST(Alicona, HasTheExpectedDepthImage) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/al3d-1.al3d");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    expect_entry_of(channels[0], expected_entry("topography/surfacetopography/al3d-1.al3d"), units::m);
    EXPECT_EQ(channels[0].info.metadata.attributes.at("software_version"), "MeasureSuite 5.3.6");
}

TEST(NtMdt, ForceCurvesAsTextAreNotTopography) {
    SETAE_REQUIRE_REFERENCE_DATA(path,
                                 "force_curves/fmt-ntmdt-txt-fd_2015_01_17_gel4-0,1_mQ_adh_6B_Curve_DFL_Height_51.txt");
    EXPECT_THROW((void)read(path.string()), Error) << "neither size nor unit stands in the file";
}

}  // namespace
}  // namespace setae::formats::binary_files_test
