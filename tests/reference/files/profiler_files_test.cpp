// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "expected_file.hpp"
#include "reference_data.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/channel.hpp"
#include "setae/tables/table_file.hpp"

// Files of stylus and optical profilers against another reader, a text export and what is known of the objects
// measured.
namespace setae::formats::profiler_files_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

std::string in_folder(const std::string& name) { return "topography/surfacetopography/" + name; }

TEST(OpdFile, HasTheExpectedHeightsSizeAndTime) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("opd-1.opd"));
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 4u);
    expect_entry_of(channels[0], expected_entry(in_folder("opd-1.opd")), units::mm);
    EXPECT_EQ(channels[0].info.name, "Raw");
    EXPECT_EQ(channels[0].info.unit, "nm");
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "7/7/2015 16:19:48");
    for (std::size_t k = 1; k < channels.size(); ++k) EXPECT_FALSE(channels[k].info.is_height) << channels[k].info.name;
}

TEST(OpdFile, ExtentsAreFromTheFirstPointToTheLast) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("opd-1.opd"));
    const auto channels = open(path.string());
    EXPECT_EQ(channels[2].info.name, "Modulation");
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(channels[2].info.size[i] / channels[0].info.size[i], 1.0, 1e-8)
            << "the same pixels by extent and by pixel size";
}

TEST(OpdxFile, AgreesWithItsTextExport) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("opdx-3.opdx"));
    SETAE_REQUIRE_REFERENCE_DATA(export_path, in_folder("opdx-3.txt"));
    const auto scan = std::get<LineScan>(read(path.string()));
    const auto exported = tables::read_raw_table(bytes::file_source(export_path.string()));
    const auto& positions = exported.columns.at(0).values;
    const auto& heights = exported.columns.at(1).values;
    ASSERT_EQ(scan.heights.size(), 3001);
    ASSERT_EQ(heights.size(), 3001);
    for (Index i = 0; i < heights.size(); ++i) {
        ASSERT_NEAR(scan.heights[i], heights[i], 5e-8 * std::abs(heights[i]) + 1e-20) << i;  // eight digits
        ASSERT_NEAR(static_cast<double>(i) * scan.pixel_size(), positions[i], 5e-8 * positions[i]) << i;
    }
    EXPECT_NEAR(scan.size / units::um, 49.98334, 1e-5);
}

TEST(OpdxFile, ReadsStylusAndInstrument) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("opdx-3.opdx"));
    const auto metadata = open(path.string()).at(0).info.metadata;
    EXPECT_EQ(metadata.instrument.name, "Dektak Profiler");
    EXPECT_EQ(metadata.instrument.type, "stylus");
    EXPECT_NEAR(metadata.instrument.tip_radius.value(), 2e-6, 1e-18);
    EXPECT_EQ(metadata.acquisition_time, "2/11/2021 11:39:13 PM");
    EXPECT_EQ(metadata.attributes.at("time_stamp"), "2021-11-02 15:39:13 UTC")
        << "2 November, as its name Reference-2021.11.02 says, not 11 February";
    EXPECT_EQ(metadata.attributes.at("data_set"), "Reference-2021.11.02_50um.OPDx");
}

TEST(MetroProFile, HasTheExpectedHeightsSizeAndTime) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("metropro-1.dat"));
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    expect_entry_of(channels[0], expected_entry(in_folder("metropro-1.dat")), units::m);
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "2011-07-23 16:49:36 UTC");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("serial_number"), "59407");
    EXPECT_EQ(channels[1].info.name, "Intensity");
    EXPECT_FALSE(channels[1].info.is_height);
}

TEST(BcrFile, HeightsMatchAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("bcrf-1.bcrf"));
    expect_heights_of(open(path.string()).at(0), expected_entry(in_folder("bcrf-1.bcrf")), units::nm);
}

/// mnt-1.mnt holds the same measurement, with the distance from point to point: xlength goes from the first to the
/// last.
TEST(BcrFile, MatchesTheSameMeasurementInAnotherFormat) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("bcrf-1.bcrf"));
    const auto channel = open(path.string()).at(0);
    const auto map = std::get<HeightMap>(channel.read());
    const auto entry = expected_entry(in_folder("mnt-1.mnt"));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(map.size[i] / units::um / entry.at("physical_sizes").at(i).get<double>(), 1.0, 1e-8) << i;
    const auto& corners = entry.at("peer_computed").at("corners_00_0m1_m10_m1m1");
    EXPECT_NEAR(map.heights(0, 0) / units::nm, corners.at(0).get<double>() * 1e3,
                1e-4);  // heights in steps of 0.1 pm and 4 pm
    EXPECT_NEAR(map.heights(959, 599) / units::nm, corners.at(3).get<double>() * 1e3, 1e-4);
    EXPECT_EQ(channel.info.alerts.at(0).code, "SIZE_BETWEEN_POINTS");
}

TEST(NmsFile, HeightsMatchAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("nms-1.nms"));
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    expect_heights_of(channels[0], expected_entry(in_folder("nms-1.nms")), units::um);
    EXPECT_EQ(channels[0].info.name, "Confocal Height Image");
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "2022-02-09T13:25");
}

/// The other reader takes the pitch of 312.5 for mm.
TEST(NmsFile, MapIs160MicrometresWide) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("nms-1.nms"));
    const auto channel = open(path.string()).at(0);
    for (const double size : channel.info.size) EXPECT_NEAR(size / units::um, 160.0, 1e-5);
}

TEST(FrtFile, HasTheExpectedHeightsSizeAndInstrument) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("frt-2.frt"));
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    expect_entry_of(channels[0], expected_entry(in_folder("frt-2.frt")), units::m);
    EXPECT_EQ(channels[0].info.metadata.attributes.at("serial_number"), "SN_1036");
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "2023-06-26 16:22:25 UTC");
    EXPECT_EQ(channels[1].info.name, "Intensity");
}

TEST(TrueMapFile, HeightsAndSizeAreInTheAssumedUnit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("tmd-1.tmd"));
    const auto channel = open(path.string()).at(0);
    expect_entry_of(channel, expected_entry(in_folder("tmd-1.tmd")), units::mm);
    EXPECT_EQ(channel.info.alerts.at(0).code, "UNIT_ASSUMED");
}

/// Highest point of a line in a range of pixels.
Index highest(const Array1D& line, Index first, Index last) {
    Index at = 0;
    (void)line.segment(first, last - first).maxCoeff(&at);
    return first + at;
}

/// The surface is a dime, 17.91 mm across the outside of its rim.
TEST(TrueMapFile, AssumedUnitGivesTheTrueSizeOfTheCoin) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("tmd-1.tmd"));
    const auto map = std::get<HeightMap>(read(path.string()));
    const Array1D middle = map.heights.col(150);
    const double across_rim =
        static_cast<double>(highest(middle, 250, 300) - highest(middle, 10, 60)) * map.pixel_size()[0];
    EXPECT_NEAR(across_rim / units::mm, 17.4, 0.6) << "from middle to middle of a rim of some 0.5 mm";
}

}  // namespace
}  // namespace setae::formats::profiler_files_test
