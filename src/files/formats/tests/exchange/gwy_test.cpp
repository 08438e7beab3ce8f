// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "counted_source.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "gwy_sample_parts.hpp"
#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/quantity_maps.hpp"

using namespace setae::tests;

namespace setae::formats::tests::gwy_test {
namespace {

using topography::HeightMap;

std::vector<Channel> opened(const std::string& content, const ReadOptions& options = {}) {
    return open(bytes::memory_source("a.gwy", content), options);
}
std::string refusal(const std::string& content) {
    return message_of([&] { (void)opened(content).at(0).read(); });
}
std::string of_field(const std::string& field) { return gwy_component("/0/data", 'o', field); }

const auto heights = lopsided_heights(4, 3, 1e-9);
const auto field = gwy_field(heights, 4e-6, 3e-6, "m", "m");

TEST(Gwy, TitlesAndMetadataAreKept) {
    const auto info = opened(gwy_samples().front().content).at(0).info;
    EXPECT_EQ(info.name, "Topography ↑");
    EXPECT_EQ(info.metadata.acquisition_time, "2020-01-02");
    EXPECT_EQ(info.metadata.attributes.at("Operator"), "Tom");
    EXPECT_TRUE(info.alerts.empty());
}

TEST(Gwy, TitleIsOptional) { EXPECT_EQ(opened(gwy_file(of_field(field))).at(0).info.name, ""); }

TEST(Gwy, TenAndMoreChannelsAreInNumericalOrder) {
    const auto channels = opened(gwy_file(gwy_component("/10/data", 'o', field) + gwy_text("/10/data/title", "b") +
                                          gwy_component("/9/data", 'o', field) + gwy_text("/9/data/title", "a")));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "a");
    EXPECT_EQ(channels[1].info.name, "b");
}

TEST(Gwy, FieldsWithOtherUnitsThanLengthAreListedOnly) {
    const auto channels =
        opened(gwy_file(of_field(gwy_field(heights, 4e-6, 3e-6, "m", "deg")) + gwy_component("/1/data", 'o', field)));
    EXPECT_FALSE(channels.at(0).info.is_height);
    EXPECT_EQ(channels[0].info.unit, "deg");
    EXPECT_TRUE(channels.at(1).info.is_height);
}

TEST(Gwy, FieldsWithoutUnitsRequireGivenUnits) {
    const auto content = gwy_file(of_field(gwy_field(heights, 1.0, 1.0, "", "")));
    const auto info = opened(content).at(0).info;
    EXPECT_EQ(missing(info), (std::vector<std::string>{"size", "unit", "instrument", "date"}));
    EXPECT_NE(refusal(content).find("`size`"), std::string::npos);
    const auto map = std::get<HeightMap>(opened(content, {.size = {{4e-6, 6e-6}}, .unit = "um"}).at(0).read());
    EXPECT_NEAR(map.heights(3, 2), 1e-6 * heights(3, 2), 1e-24);
}

TEST(Gwy, PrefixOfTheUnitIsAppliedWithAWarning) {
    const auto info = opened(gwy_file(of_field(gwy_field(heights, 4.0, 3.0, "µm", "nm")))).at(0).info;
    ASSERT_EQ(info.alerts.size(), 1u);
    EXPECT_EQ(info.alerts[0].code, "UNIT_PREFIX");
    EXPECT_DOUBLE_EQ(info.size[0], 4e-6);
}

TEST(Gwy, NegativeExtentIsReadAsALength) {
    EXPECT_EQ(opened(gwy_file(of_field(gwy_field(heights, -4e-6, 3e-6, "m", "m")))).at(0).info.size[0], 4e-6);
}

TEST(Gwy, MaskIsNotApplied) {
    const auto channels = opened(gwy_file(
        of_field(field) + gwy_component("/0/mask", 'o', gwy_field(Array2D::Constant(4, 3, 1.0), 4e-6, 3e-6, "m", ""))));
    ASSERT_EQ(channels.at(0).info.alerts.size(), 1u);
    EXPECT_EQ(channels[0].info.alerts[0].code, "MASK_NOT_APPLIED");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("mask"), "there, not applied");
    EXPECT_EQ(std::get<HeightMap>(channels[0].read()).heights.isNaN().count(), 0);
}

TEST(Gwy, FilesWithoutMapsAndOfOtherVersionsAreRefused) {
    EXPECT_NE(refusal(gwy_file(gwy_text("/filename", "x"))).find("GWY: no map"), std::string::npos);
    EXPECT_EQ(
        refusal("GWYO" + gwy_object("GwyContainer", "")),
        "a.gwy: at byte 3: GWY: begins with 'GWYO', which is of Gwyddion 1, expected 'GWYP'; open it in Gwyddion 2 and save it again");
    EXPECT_NE(refusal("GWYQ" + gwy_object("GwyContainer", "")).find("of a newer Gwyddion"), std::string::npos);
    EXPECT_NE(refusal("GWYP" + gwy_object("GwyBrick", "")).find("contains 'GwyBrick'"), std::string::npos);
}

TEST(Gwy, DamagedFilesAreRefusedWithTheOffset) {
    EXPECT_NE(
        refusal(gwy_file(gwy_component("a", 'z', ""))).find("at byte 23: GWY: component 'a' has the type '\\x7a'"),
        std::string::npos)
        << refusal(gwy_file(gwy_component("a", 'z', "")));
    auto wrong_count = field;
    wrong_count[wrong_count.find("xres") + 6] = 5;
    EXPECT_NE(refusal(gwy_file(of_field(wrong_count))).find("channel 0 has 12 values for 5 × 3 points"),
              std::string::npos);
    const auto unit = gwy_field(heights, 4e-6, 3e-6, "m", "m");
    auto shorter = unit;
    shorter[std::string("GwyDataField").size() + 1] = 40;  // the field ends within its component xreal or after
    EXPECT_NE(refusal(gwy_file(of_field(shorter))).find("GWY: "), std::string::npos);
}

TEST(Gwy, ComponentsWithoutEndAreRefused) {
    std::string small;
    for (int k = 0; k < 200'001; ++k) small += std::string("\0b\1", 3);
    EXPECT_NE(refusal(gwy_file(small)).find("more than 200000 components"), std::string::npos);
}

TEST(Gwy, OpeningAGigabyteReadsHeadersOnly) {
    auto small = gwy_file(of_field(field) + gwy_text("/0/data/title", "behind the heights"));
    const std::uint64_t more = std::uint64_t{8} * (11264 * 11264 - 12);
    const auto grow = [&](const std::string& name) {  // the size of an object after its name
        std::uint32_t size = 0;
        const auto at = small.find(name + '\0') + name.size() + 1;
        std::memcpy(&size, small.data() + at, sizeof(size));
        size += static_cast<std::uint32_t>(more);
        std::memcpy(small.data() + at, &size, sizeof(size));
    };
    grow("GwyContainer");
    grow("GwyDataField");
    const auto put = [&](const std::string& name, std::uint32_t value) {
        std::memcpy(small.data() + small.find(name) + name.size(), &value, sizeof(value));
    };
    using namespace std::string_literals;
    put("xres\0i"s, 11264);
    put("yres\0i"s, 11264);
    put("data\0D"s, 11264 * 11264);
    const auto heights_end = small.find("data\0D"s) + 10 + 12 * 8;
    const CountedSource file(small.substr(0, heights_end), more, small.substr(heights_end));
    const auto info = open(file.source(), {}).at(0).info;
    EXPECT_EQ(info.shape, (std::vector<Index>{11264, 11264}));
    EXPECT_EQ(info.name, "behind the heights");
    EXPECT_LT(file.bytes(), 1u << 20);
}

// ---- written
// ----------------------------------------------------------------------------------------------------------

HeightMap small_map() {
    HeightMap map{heights, {4e-6, 3.5e-6}, false, {}};
    map.metadata.name = "Höhe";
    map.metadata.acquisition_time = "09:57:48 AM Tue Jan 12 2016";
    map.metadata.instrument.name = "Scope";
    map.metadata.instrument.type = "afm";
    map.metadata.attributes["Operator"] = "Tom";
    return map;
}

TEST(GwyWriter, WritesTheLayoutOfTheUserGuide) {
    const TemporaryFolder folder;
    format_to_write("a.gwy").write(folder.path("a.gwy"), small_map());
    const auto meta =
        gwy_object("GwyContainer", gwy_text("Operator", "Tom") + gwy_text("Date", "09:57:48 AM Tue Jan 12 2016") +
                                       gwy_text("Instrument", "Scope") + gwy_text("Instrument type", "afm"));
    EXPECT_EQ(bytes::read_file(folder.path("a.gwy")),
              gwy_file(gwy_text("/0/data/title", "Höhe") + gwy_component("/0/meta", 'o', meta) +
                       of_field(gwy_field(heights, 4e-6, 3.5e-6, "m", "m"))));
}

TEST(GwyWriter, UndefinedPointsAreMaskedAndReadBackAsUndefined) {
    auto map = small_map();
    map.heights(2, 1) = map.heights(0, 0) = NAN;
    const TemporaryFolder folder;
    format_to_write("a.gwy").write(folder.path("a.gwy"), map);
    const auto channel = open(folder.path("a.gwy")).at(0);
    EXPECT_TRUE(channel.info.alerts.empty());
    EXPECT_FALSE(channel.info.metadata.attributes.contains("mask"));
    const auto back = std::get<HeightMap>(channel.read()).heights;
    EXPECT_TRUE((back == map.heights || (back.isNaN() && map.heights.isNaN())).all());
    // without the entry of the metadata it is a mask like others, over finite heights: their mean
    auto content = bytes::read_file(folder.path("a.gwy"));
    content.replace(content.find("Undefined points"), 9, "Unknown  ");
    const auto plain = std::get<HeightMap>(opened(content).at(0).read()).heights;
    EXPECT_EQ(plain.isNaN().count(), 0);
    const double mean = map.heights.isNaN().select(0.0, map.heights).sum() / 10.0;
    EXPECT_NEAR(plain(2, 1), mean, 1e-22);
}

TEST(GwyWriter, LinesAreRefusedWithTheFormatsThatHoldThem) {
    const topography::LineScan line{Array1D::Zero(3), 1.0, false, {}};
    EXPECT_EQ(
        message_of([&] { format_to_write("a.gwy").write("a.gwy", line); }),
        "a.gwy: Gwyddion's format can hold only maps, and this is a line; write it as .x3p, .sdf, .nc, .npy or .csv");
}

TEST(QuantityMaps, AreWrittenInTheirUnitsWithUndefinedPointsMasked) {
    Array2D modulus(3, 2);
    modulus << 1.0, 2.0, 3.0, 4.0, NAN, 6.0;
    const TemporaryFolder folder;
    write_quantity_maps(folder.path("a.gwy"), {{"contact_modulus", "Pa", modulus}, {"height", "m", 1e-9 * modulus}},
                        {6e-6, 2e-6});
    const auto channels = open(folder.path("a.gwy"));
    ASSERT_EQ(channels.size(), 2U);
    EXPECT_EQ(channels[0].info.name, "contact_modulus");
    EXPECT_EQ(channels[0].info.unit, "Pa");
    EXPECT_FALSE(channels[0].info.is_height);
    const auto height = std::get<HeightMap>(channels[1].read());
    EXPECT_EQ(height.size, (std::array{6e-6, 2e-6}));
    const Array2D expected = 1e-9 * modulus;
    EXPECT_TRUE((height.heights == expected || (height.heights.isNaN() && expected.isNaN())).all());
}

TEST(QuantityMaps, RefuseMapsOfDifferentShapes) {
    EXPECT_THROW(write_quantity_maps("a.gwy", {}, {1.0, 1.0}), InvalidArgument);
    EXPECT_EQ(message_of([] {
                  write_quantity_maps("a.gwy", {{"a", "Pa", Array2D::Zero(3, 2)}, {"b", "N", Array2D::Zero(2, 2)}},
                                      {1.0, 1.0});
              }),
              "a.gwy: 'b' has 2 × 2 points, but the maps before 3 × 2");
}

}  // namespace
}  // namespace setae::formats::tests::gwy_test
