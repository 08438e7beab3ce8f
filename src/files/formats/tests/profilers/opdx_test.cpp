// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "patched_sample.hpp"
#include "setae/core/constants.hpp"
#include "vca_builder.hpp"

namespace setae::formats::tests::opdx_test {
namespace {

const std::string signature("VCA DATA\x01\x00\x00\x55", 12);

std::string line(const std::string& more) {
    return signature +
           vca::container(
               "1D_Data",
               {vca::container("Raw", {vca::array<double>("Array", Array1D::LinSpaced(5, 0.0, 4.0)), more}, 0x46)});
}

TEST(Opdx, ExtentIsFromTheFirstPointToTheLast) {
    const auto file = line(vca::quantity("Extent", 8.0, "Micrometer", "\xc2\xb5m") +
                           vca::quantity("DataScale", 1.0, "Nanometer", "nm"));
    EXPECT_NEAR(channels_of(file).at(0).info.size.at(0), 10e-6, 1e-18) << "five points, 2 µm apart";
}

TEST(Opdx, ListsEveryMapWithThePrimaryFirst) {
    const auto channels = channels_of(opdx_samples().at(0).content);
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].info.name, "Height");
    EXPECT_EQ(channels[1].info.name, "Filled");
    EXPECT_EQ(channels[2].info.name, "Intensity");
    EXPECT_FALSE(channels[2].info.is_height);
    const auto primary = map_of(channels[0]).heights, filled = map_of(channels[1]).heights;
    EXPECT_DOUBLE_EQ(filled(6, 3), 2.0 * primary(6, 3));
}

TEST(Opdx, MatrixOfAnonymousTypeIsRead) {
    const auto named = map_of(channels_of(opdx_samples().at(0).content).at(0)),
               anonymous = map_of(channels_of(opdx_samples().at(1).content).at(0));
    EXPECT_TRUE((named.heights.isNaN() || named.heights == anonymous.heights).all());
}

TEST(Opdx, ReadsInstrumentStylusAndTime) {
    const auto metadata = channels_of(opdx_samples().at(3).content).at(0).info.metadata;
    EXPECT_EQ(metadata.instrument.name, "Dektak Profiler");
    EXPECT_EQ(metadata.instrument.type, "stylus");
    EXPECT_NEAR(metadata.instrument.tip_radius.value(), 2e-6, 1e-18);
    EXPECT_EQ(metadata.acquisition_time, "2/11/2021 11:39:13 PM")
        << "as the file says it: day and month may be in either order";
    EXPECT_EQ(metadata.attributes.at("time_stamp"), "2021-11-02 15:39:13 UTC") << "the file's own answer";
    EXPECT_EQ(metadata.attributes.at("stylus_force"), "3 mg");
}

TEST(Opdx, ProfileWithoutScaleRequiresAUnit) {
    const auto file = line(vca::quantity("Extent", 8.0, "Micrometer", "um"));
    EXPECT_NE(refusal(file).find("the file states no unit"), std::string::npos);
    EXPECT_DOUBLE_EQ(
        std::get<topography::LineScan>(channels_of(file, {.size = {}, .unit = "nm"}).at(0).read()).heights[3], 3e-9);
}

TEST(Opdx, ProfileWithAWrongNumberOfPointsIsRefused) {
    EXPECT_NE(refusal(line(vca::number<std::uint64_t>("NumPoints", 0x0b, 6))).find("announces 6 points but has 5"),
              std::string::npos);
}

TEST(Opdx, UnknownTypeIsRefusedWithTheOffset) {
    EXPECT_EQ(refusal(signature + vca::item("odd", 0x33, "")),
              "file: at byte 19: OPDx: entry 'odd' is of the unknown type 0x33");
}

TEST(Opdx, EntriesBeyondTheirContainerAreRefused) {
    auto file =
        signature + vca::container("MetaData", {vca::string("Date", "2/11/2021")}) + vca::string("Time", "11:39:13 PM");
    file[signature.size() + 14] = 12;  // bytes of the container
    EXPECT_NE(refusal(file).find("extends beyond the entry that contains it"), std::string::npos) << refusal(file);
}

TEST(Opdx, EntriesNestedWithoutEndAreRefused) {
    std::string nested;
    for (int depth = 0; depth < 40; ++depth) nested = vca::container("c", {nested});
    EXPECT_NE(refusal(signature + nested).find("nested deeper than 16"), std::string::npos);
}

TEST(Opdx, MatrixWithPartialValuesIsRefused) {
    const auto matrix = vca::matrix<float>("Matrix", Array2D::Zero(3, 2), false);
    const auto dimensions = matrix.size() - 3 * 2 * sizeof(float) - 4;
    const auto file =
        signature +
        vca::container("2D_Data", {vca::container("Raw", {with_number<std::uint32_t>(matrix, dimensions, 5)}, 0x47)});
    EXPECT_NE(refusal(file).find("expected 4 or 8 bytes per value"), std::string::npos) << refusal(file);
}

}  // namespace
}  // namespace setae::formats::tests::opdx_test
