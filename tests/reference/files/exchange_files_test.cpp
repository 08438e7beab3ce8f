// SPDX-License-Identifier: GPL-3.0-or-later
// Exchange formats: files of others, against numbers of others.
#include <cmath>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats::exchange_files_test {
namespace {

using topography::HeightMap;

double standard_deviation(const Array2D& heights) { return std::sqrt((heights - heights.mean()).square().mean()); }

/// Corners h(0, 0), h(0, −1), h(−1, 0), h(−1, −1).
void expect_corners(const HeightMap& map, const std::array<double, 4>& corners, double tolerance) {
    const auto nx = map.heights.rows() - 1, ny = map.heights.cols() - 1;
    EXPECT_NEAR(map.heights(0, 0), corners[0], tolerance);
    EXPECT_NEAR(map.heights(0, ny), corners[1], tolerance);
    EXPECT_NEAR(map.heights(nx, 0), corners[2], tolerance);
    EXPECT_NEAR(map.heights(nx, ny), corners[3], tolerance);
}

// numbers of SurfaceTopography 1.27.1 and its tests (expected/topography_files.json)
TEST(X3p2, AgreesWithSurfaceTopography) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/x3p-2.x3p");
    const auto channel = open(path.string()).at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{650, 650}));
    EXPECT_NEAR(channel.info.size.at(0), 8.29767313942749e-05, 1e-19);
    EXPECT_NEAR(channel.info.size.at(1), 0.0002044783737930349, 1e-18);
    EXPECT_EQ(channel.info.unit, "m");
    EXPECT_EQ(channel.info.orientation, "rows from the top, as stored");
    EXPECT_TRUE(channel.info.alerts.empty());
    const auto map = std::get<HeightMap>(channel.read());
    EXPECT_EQ(map.heights.isNaN().count(), 0);
    EXPECT_NEAR(standard_deviation(map.heights), 7.728033273597876e-08, 1e-6 * 7.7e-8);
    EXPECT_NEAR(map.heights.mean(), -2.491824169305575e-09, 1e-17);
    expect_corners(map, {6.579781341223288e-08, 9.597611341223287e-08, -4.133318658776711e-08, -3.276918658776711e-08},
                   1e-20);
}

TEST(X3p2, PlaceholdersAreNotReadAsMetadata) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/x3p-2.x3p");
    const auto info = open(path.string()).at(0).info;
    EXPECT_EQ(info.metadata.acquisition_time, "");  // the file states 1970-01-01T01:00:00
    EXPECT_EQ(info.metadata.instrument.name, "Mountains Map Technology Software");
    EXPECT_EQ(info.metadata.attributes.at("manufacturer"), "DIGITAL SURF");
    EXPECT_FALSE(info.metadata.attributes.contains("serial_number"));  // "not available"
}

TEST(IsoSamples, NameTheOperator) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/x3p/ISO5436-sample4_bin.x3p");
    const auto info = open(path.string()).at(0).info;
    EXPECT_EQ(info.shape, (std::vector<Index>{4, 4}));
    EXPECT_NEAR(info.size.at(0), 4 * 1.6016e-2, 1e-15);
    EXPECT_EQ(info.metadata.acquisition_time, "2007-04-30T13:58:02.6+02:00");
    EXPECT_EQ(info.metadata.instrument.name, "µSurf X");
    EXPECT_EQ(info.metadata.attributes.at("probing_system"), "NonContacting");
}

/// y is absolute int16 with the increment 2: rows 1 … 4 lie 2 m apart; z has the offset 2.
TEST(IsoSamples, AbsoluteAxisGivesTheSize) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/x3p/ISO5436-sample3.x3p");
    const auto map = std::get<HeightMap>(read(path.string()));
    EXPECT_NEAR(map.size[0], 4 * 1.6016e-2, 1e-15);
    EXPECT_NEAR(map.size[1], 8.0, 1e-12);
    EXPECT_NEAR(map.heights(0, 0), 2.486219120804151, 1e-12);
    EXPECT_TRUE(std::isnan(map.heights(3, 1)));
    EXPECT_NEAR(map.heights(3, 3), 1.784303361535036, 1e-12);
}

TEST(Pyramid, HasItsMaximumInTheMiddle) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/x3p/pyramid.x3p");
    const auto map = std::get<HeightMap>(read(path.string()));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{5, 5}));
    EXPECT_EQ(map.size, (std::array<double, 2>{5.0, 5.0}));
    EXPECT_EQ(map.heights.maxCoeff(), map.heights(2, 2));
    EXPECT_TRUE((map.heights == map.heights.transpose()).all());
}

TEST(Sdf1, HasTheNumbersPrintedInTheFile) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/sdf-1.sdf");
    const auto channel = open(path.string()).at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{7, 4}));
    EXPECT_NEAR(channel.info.size.at(0), 7e-6, 1e-20);
    EXPECT_NEAR(channel.info.size.at(1), 4e-6, 1e-20);
    EXPECT_EQ(channel.info.metadata.instrument.name, "ISOTC213");
    EXPECT_EQ(channel.info.metadata.acquisition_time, "2010-01-04 08:53");
    EXPECT_EQ(channel.info.metadata.attributes.at("OperatorName"), "Tom Jones");
    EXPECT_EQ(channel.info.metadata.attributes.at("PartName"), "S2 Softgauges Example");
    const auto map = std::get<HeightMap>(channel.read());
    EXPECT_NEAR(standard_deviation(map.heights), 0.013602897289488262e-6, 1e-6 * 1.36e-8);
    EXPECT_NEAR(map.heights.mean(), 0.9835632142857144e-6, 1e-18);
    EXPECT_NEAR(map.heights.minCoeff(), 0.94907e-6, 1e-18);
    expect_corners(map, {1e-6, 0.97986e-6, 1e-6, 0.97986e-6}, 1e-18);
    EXPECT_NEAR(map.heights(6, 3) - map.heights(5, 3), (0.97986 - 0.94907) * 1e-6, 1e-18);
}

/// The file states no units. data[row][column] as gwyfile 0.3.0 (PyPI) reads it, and its mean and standard deviation.
TEST(TestGwy, HasTheHeightsOfThePackage) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/gwyddion/test.gwy");
    const auto channel = open(path.string()).at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{128, 128}));
    EXPECT_EQ(channel.info.name, "Test");
    EXPECT_EQ(missing(channel.info).at(0), "size");
    EXPECT_EQ(missing(channel.info).at(1), "unit");
    const auto map = std::get<HeightMap>(read(path.string(), 0, {.size = {{1e-6, 1e-6}}, .unit = "m"}));
    EXPECT_DOUBLE_EQ(map.heights(0, 0), 0.0008249385446819946);
    EXPECT_DOUBLE_EQ(map.heights(33, 44), 0.0008530156002708358);
    EXPECT_DOUBLE_EQ(map.heights(44, 33), 0.0006755414017863563);
    EXPECT_NEAR(map.heights.mean(), 0.0005152968462939743, 1e-16);
    EXPECT_NEAR(standard_deviation(map.heights), 0.00018771126171581148, 1e-16);
}

}  // namespace
}  // namespace setae::formats::exchange_files_test
