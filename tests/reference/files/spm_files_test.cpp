// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "flattened_lines.hpp"
#include "reference_data.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::formats::spm_files_test {
namespace {

using topography::HeightMap;

HeightMap map_of(const Channel& channel) { return std::get<HeightMap>(channel.read()); }

double spread(const Array2D& heights) { return std::sqrt((heights - heights.mean()).square().mean()); }

/// h[0,0], h[0,-1], h[-1,0], h[-1,-1] as expected/topography_files.json has them.
std::array<double, 4> corners(const HeightMap& map, double unit) {
    const auto nx = map.heights.rows() - 1, ny = map.heights.cols() - 1;
    return {map.heights(0, 0) / unit, map.heights(0, ny) / unit, map.heights(nx, 0) / unit, map.heights(nx, ny) / unit};
}

void expect_corners(const HeightMap& map, double unit, const std::array<double, 4>& expected) {
    const auto found = corners(map, unit);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(found[k], expected[k], 1e-9 * std::abs(expected[k])) << "corner " << k;
}

const Channel& named(const std::vector<Channel>& channels, const std::string& name) {
    for (const auto& channel : channels)
        if (channel.info.name == name) return channel;
    throw std::runtime_error("no channel " + name);
}

/// Pearson's correlation of two maps.
double correlation(const Array2D& a, const Array2D& b) {
    return ((a - a.mean()) * (b - b.mean())).mean() / (spread(a) * spread(b));
}

TEST(JpkFile, SumOfHeightsMatchesThePublishedOne) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/afmreader/sample_0.jpk");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 10u);
    const auto map = map_of(named(channels, "Height (trace)"));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{256, 256}));
    EXPECT_NEAR(map.pixel_size()[0] / units::nm, 1.2770176335964876, 1e-12);
    EXPECT_NEAR(map.pixel_size()[1] / units::nm, 1.2770176335964876, 1e-12);
    EXPECT_NEAR(map.heights.sum() / units::nm, 219242202.8256843, 1e-9 * 219242202.8256843);
    EXPECT_EQ(map.metadata.acquisition_time, "2017-01-16 16:00:32.334 GMT");
}

TEST(JpkFile, ListsEveryChannelWithItsUnit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/afmreader/sample_0.jpk");
    const auto channels = open(path.string());
    EXPECT_TRUE(named(channels, "Height (measured, retrace)").info.is_height);
    EXPECT_EQ(named(channels, "Lock-In Phase (trace)").info.unit, "deg");
    EXPECT_EQ(named(channels, "Error Signal (retrace)").info.unit, "V");
    EXPECT_EQ(named(channels, "Lock-In Amplitude (trace)").info.unit, "m");
    EXPECT_FALSE(named(channels, "Lock-In Amplitude (trace)").info.is_height);
}

TEST(JpkFile, MeasuredHeightFollowsThePiezoHeight) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/afmreader/sample_0.jpk");
    const auto channels = open(path.string());
    EXPECT_GT(correlation(map_of(named(channels, "Height (trace)")).heights,
                          map_of(named(channels, "Height (measured, trace)")).heights),
              0.9);
    EXPECT_GT(correlation(map_of(named(channels, "Height (trace)")).heights,
                          map_of(named(channels, "Height (retrace)")).heights),
              0.9);
}

TEST(JpkQiFile, SumOfHeightsMatchesThePublishedOne) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/afmreader/sample_0.jpk-qi-image");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 6u);
    const auto map = map_of(named(channels, "Height (trace)"));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{100, 100}));
    EXPECT_NEAR(map.pixel_size()[0] / units::nm, 5.0, 1e-12);
    EXPECT_NEAR(map.heights.sum() / units::nm, 31593146.16051172, 1e-9 * 31593146.16051172);
    EXPECT_EQ(named(channels, "Adhesion (trace)").info.unit, "N");
    EXPECT_EQ(named(channels, "Slope (trace)").info.unit, "N/m");
    EXPECT_TRUE(named(channels, "Height (measured, trace): Ref. Force Height at 40%").info.is_height);
}

TEST(ParkFile, HasShapeSizeAndHeightsOfAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/example_ps.tiff");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    const auto map = map_of(channels[0]);
    EXPECT_EQ(channels[0].info.name, "Z Height");
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{512, 512}));
    EXPECT_NEAR(map.size[0], 1e-6, 1e-18);
    EXPECT_NEAR(spread(map.heights) / units::um, 0.003933333733759224, 1e-6 * 0.0039333);
    expect_corners(map, units::um,
                   {-0.002019951078814785, 0.0038381673206220246, 0.0008950688309749014, 0.0020836386214921217});
    EXPECT_EQ(map.metadata.attributes.at("cantilever"), "NCHR");
    EXPECT_EQ(map.metadata.acquisition_time, "2022:10:15 17:07:06");
}

TEST(ParkFile, OrientationMatchesThePictureInTheFile) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/example_ps.tiff");
    const auto map = map_of(open(path.string()).at(0));
    const auto bytes =
        bytes::file_source(path.string()).bytes(1051403, 256 * 256);  // the only page: 8 bits, strips side by side
    Array2D heights(256, 256), picture(256, 256);
    for (Index i = 0; i < 256; ++i)
        for (Index j = 0; j < 256; ++j) {
            heights(i, j) = map.heights.block(2 * i, 2 * j, 2, 2).mean();
            picture(i, j) = static_cast<unsigned char>(bytes[static_cast<std::size_t>(256 * j + i)]);
        }
    EXPECT_GT(correlation(heights, picture), 0.95);
    EXPECT_LT(std::abs(correlation(heights.rowwise().reverse(), picture)), 0.1);
    EXPECT_LT(std::abs(correlation(heights.colwise().reverse(), picture)), 0.1);
    EXPECT_LT(std::abs(correlation(heights.transpose(), picture)), 0.1);
}

TEST(IbwFile, HeightsMatchAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/spot_1-1000nm.ibw");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 8u);
    const auto trace = map_of(named(channels, "HeightTrace")), retrace = map_of(named(channels, "HeightRetrace"));
    EXPECT_EQ(trace.shape(), (std::array<Index, 2>{256, 256}));
    EXPECT_NEAR(spread(trace.heights), 8.945481491256412e-08, 1e-6 * 8.945e-8);
    expect_corners(trace, 1.0,
                   {-3.9969469867173757e-07, -3.3123345133390103e-07, -7.045921961434942e-07, -6.817558642069343e-07});
    EXPECT_NEAR(spread(retrace.heights), 1.1028457213263467e-07, 1e-6 * 1.1e-7);
    expect_corners(retrace, 1.0,
                   {-3.0985046350906487e-07, -2.915543859671743e-07, -6.877208988953498e-07, -6.616979817408719e-07});
    EXPECT_EQ(trace.metadata.instrument.name, "Cypher");
    EXPECT_EQ(trace.metadata.acquisition_time, "2019-10-24 12:14:13 PM");
}

/// Igor's point k lies at k · sfA, and Asylum sets sfA to scan size over n − 1: from the first point to the last are 20
/// µm, and the map of 256 pixels is 256 sfA wide.
TEST(IbwFile, ScanSizeLiesBetweenFirstAndLastPoint) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/spot_1-1000nm.ibw");
    const auto map = map_of(open(path.string()).at(0));
    EXPECT_EQ(map.metadata.attributes.at("scan_size"), "2e-05");
    EXPECT_NEAR(255.0 * map.pixel_size()[0], 2e-5, 1e-17);
    EXPECT_NEAR(map.size[0], 2.007843137254902e-05, 1e-17);
    EXPECT_NEAR(map.size[1], 2.007843137254902e-05, 1e-17);
}

/// The wave states "m" for all eight channels, also for volts and degrees.
TEST(IbwFile, PotentialIsNotALength) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/spot_1-1000nm.ibw");
    const auto channels = open(path.string());
    for (const auto& [name, unit] : {std::pair{"NapPotentialTrace", "V"},
                                     {"NapPotentialRetrace", "V"},
                                     {"PhaseTrace", "deg"},
                                     {"AmplitudeRetrace", "m"}}) {
        EXPECT_EQ(named(channels, name).info.unit, unit) << name;
        EXPECT_FALSE(named(channels, name).info.is_height) << name;
    }
}

TEST(IbwFile, WithoutUnitUsesTheGivenUnit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/10x10-one_channel_without_name.ibw");
    const auto open_question = open(path.string()).at(0);
    EXPECT_TRUE(open_question.info.unit.empty());
    EXPECT_TRUE(open_question.info.size.empty());
    EXPECT_THROW((void)open_question.read(), InvalidArgument);
    const auto map = map_of(open(path.string(), {.size = {{10e-9, 10e-9}}, .unit = "nm"}).at(0));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{10, 10}));
    EXPECT_NEAR(spread(map.heights) / units::nm, 0.480049350063276, 1e-6);
    expect_corners(map, units::nm, {1.0, 1.0, 2.0, 2.0});
}

TEST(MiFile, HeightsMatchAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/mi-1.mi");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 4u);
    const auto map = map_of(named(channels, "Topography (trace)"));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{256, 256}));
    EXPECT_NEAR(map.size[0], 20e-6, 1e-17);
    EXPECT_NEAR(map.size[1], 20e-6, 1e-17);
    EXPECT_NEAR(spread(map.heights) / units::um, 0.033215426493512654, 1e-6 * 0.0332);
    expect_corners(map, units::um,
                   {-0.49869003295898445, -0.5122423553466797, -0.5981623077392578, -0.6289871978759767});
    EXPECT_EQ(map.metadata.acquisition_time, "Tue Feb 18 15:00:51 2014");
    EXPECT_EQ(channels[3].info.name, "Friction (retrace)");
    for (std::size_t k = 1; k < 4; ++k) {
        EXPECT_FALSE(channels[k].info.is_height);
        EXPECT_EQ(channels[k].info.unit, "V");
    }
}

/// The rms that its manufacturer's package publishes for this file, after the best straight line of each line of the
/// scan is removed.
TEST(NanosurfFile, RmsAfterFlatteningMatchesThePublishedOne) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/nanosurf/sapphire.nid");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 8u);
    const auto map = map_of(named(channels, "Z-Axis (Scan forward)"));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{256, 256}));
    EXPECT_NEAR(map.size[0], 2.5e-6, 1e-18);
    const Array2D heights = tests::flattened_lines(map, 1).heights / units::nm;
    EXPECT_NEAR(std::sqrt(heights.square().mean()), 0.042123098751831574, 1e-9);
}

TEST(NanosurfFile, ListsForwardAndBackwardChannels) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/nanosurf/sapphire.nid");
    const auto channels = open(path.string());
    EXPECT_EQ(named(channels, "Phase (Scan backward)").info.unit, "deg");
    EXPECT_EQ(named(channels, "Amplitude (Scan forward)").info.unit, "V");
    const auto forward = tests::flattened_lines(map_of(named(channels, "Z-Axis (Scan forward)")), 1).heights,
               backward = tests::flattened_lines(map_of(named(channels, "Z-Axis (Scan backward)")), 1).heights;
    EXPECT_GT(correlation(forward, backward), correlation(forward, backward.colwise().reverse()));
}

TEST(NanoscopeFile, ListsEachChannelWithDirectionAndUnit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/di-1.di");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 4u);
    EXPECT_EQ(channels[0].info.name, "Height (trace)");
    EXPECT_EQ(channels[1].info.name, "Height (retrace)");
    EXPECT_EQ(channels[2].info.unit, "deg");
    EXPECT_EQ(channels[3].info.unit, "mV");
    EXPECT_EQ(channels[0].info.metadata.acquisition_time, "09:57:48 AM Tue Jan 12 2016");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("scan_angle"), "1.5708");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("scan_direction"), "down");
}

TEST(NanoscopeFile, AmplitudeInVoltsIsNotAHeight) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/nanoscope/full_multiple_images.txt");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_NEAR(channels[0].info.size.at(0), 2e-6, 1e-18);
    EXPECT_EQ(channels[1].info.name, "Amplitude (retrace)");
    EXPECT_EQ(channels[1].info.unit, "V");
    EXPECT_FALSE(channels[1].info.is_height);
}

}  // namespace
}  // namespace setae::formats::spm_files_test
