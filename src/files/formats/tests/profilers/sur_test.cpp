// SPDX-License-Identifier: GPL-3.0-or-later
#include "sur_samples.hpp"

#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::sur_test {
namespace {

std::vector<Channel> opened(const std::string& content, const ReadOptions& options = {}) {
    return open(bytes::memory_source("a.sur", content), options);
}

const topography::HeightMap map_of(const Channel& channel) { return std::get<topography::HeightMap>(channel.read()); }

SurObject flagged(std::uint16_t special_points) {
    return {.raw = lopsided_heights(5, 4, 1.0), .special_points = special_points, .least = 7};
}

TEST(Sur, ValueTwoBelowTheMinimumIsUndefinedOnlyIfFlagged) {
    auto object = flagged(1);
    object.raw(1, 1) = 5.0;
    EXPECT_EQ(map_of(opened(sur_object(object))[0]).heights.isNaN().count(), 1);
    object.special_points = 0;
    EXPECT_EQ(map_of(opened(sur_object(object))[0]).heights.isNaN().count(), 0);
}

TEST(Sur, OffsetOfHeightsIsAdded) {
    auto object = flagged(0);
    object.raw.setZero();
    object.raw(0, 0) = 1.0;
    const auto heights = map_of(opened(sur_object(object))[0]).heights;
    EXPECT_DOUBLE_EQ(heights(1, 1), 3.0 * units::nm);
    EXPECT_DOUBLE_EQ(heights(0, 0), 5.0 * units::nm);
}

TEST(Sur, CompressedHeightsEqualPlainHeights) {
    auto object = flagged(1);
    const auto plain = map_of(opened(sur_object(object))[0]);
    for (const int streams : {1, 3}) {
        object.streams = streams;
        const auto expanded = map_of(opened(sur_object(object))[0]);
        EXPECT_TRUE((expanded.heights == plain.heights).all()) << streams;
    }
}

TEST(Sur, ReadsMicrometresInTheDosCharacterSet) {
    const auto channel = opened(sur_object(flagged(0)))[0];  // x in "\xe6m", y in "\xb5m"
    EXPECT_DOUBLE_EQ(channel.info.size.at(0), 5 * 0.5 * units::um);
    EXPECT_DOUBLE_EQ(channel.info.size.at(1), 4 * 0.25 * units::um);
}

TEST(Sur, DateIsOptional) {
    auto object = flagged(0);
    EXPECT_EQ(opened(sur_object(object))[0].info.metadata.acquisition_time, "");
    object.dated = true;
    object.acquisition = 1;
    const auto metadata = opened(sur_object(object))[0].info.metadata;
    EXPECT_EQ(metadata.acquisition_time, "2014-09-29T10:58:26");
    EXPECT_EQ(metadata.instrument.type, "stylus");
    EXPECT_EQ(metadata.attributes.at("operator"), "A. Operator");
    EXPECT_EQ(metadata.attributes.at("object"), "wafer 3");
}

TEST(Sur, InvertedHeightsAreNegated) {
    auto object = flagged(0);
    const Array2D upright = map_of(opened(sur_object(object))[0]).heights - 3.0 * units::nm;
    object.inversion = 1;
    const Array2D negated = map_of(opened(sur_object(object))[0]).heights - 3.0 * units::nm;
    EXPECT_LT((upright + negated).abs().maxCoeff(), 1e-21);
}

TEST(Sur, MissingUnitOfHeightsIsTakenFromTheUser) {
    auto object = flagged(0);
    object.z_unit = "";
    const auto content = sur_object(object);
    EXPECT_EQ(missing(opened(content)[0].info).front(), "unit");
    EXPECT_THROW((void)opened(content)[0].read(), InvalidArgument);
    const auto heights = map_of(opened(content, {.size = {}, .unit = "um"})[0]).heights;
    EXPECT_NEAR(heights(1, 0) - heights(0, 0), 2.0 * units::um * (object.raw(1, 0) - object.raw(0, 0)), 1e-18);
}

TEST(Sur, ColoursAndOtherQuantitiesAreListedOnly) {
    auto object = flagged(0);
    object.type = 16;
    object.channels = 4;
    auto content = sur_object(object);
    for (int i = 0; i < 3; ++i) content += sur_object(flagged(0));
    const auto channels = opened(content);
    ASSERT_EQ(channels.size(), 4u);
    EXPECT_TRUE(channels[0].info.is_height);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(channels[i].info.is_height);
    auto volts = flagged(0);
    volts.z_unit = "V";
    EXPECT_FALSE(opened(sur_object(volts))[0].info.is_height);
}

TEST(Sur, EveryLayerIsAChannel) {
    auto object = flagged(0);
    object.type = 8;
    object.objects = 3;
    auto content = sur_object(object);
    for (int i = 1; i < 3; ++i) {
        object.raw += 100.0;
        content += sur_object(object);
    }
    const auto channels = opened(content);
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[2].info.name, "Height 3");
    EXPECT_NEAR(map_of(channels[2]).heights(0, 0) - map_of(channels[0]).heights(0, 0), 200 * 2.0 * units::nm, 1e-18);
}

TEST(Sur, ForceCurvesAndSpectraAreRefused) {
    auto object = flagged(0);
    object.type = 14;
    EXPECT_NE(message_of([&] { (void)opened(sur_object(object)); }).find("setae jkr fit"), std::string::npos);
    object.type = 21;
    EXPECT_NE(message_of([&] { (void)opened(sur_object(object)); }).find("objects of type 21"), std::string::npos);
}

TEST(Sur, DamagedHeadersAreRefusedWithTheOffset) {
    const auto content = sur_object(flagged(0));
    const auto changed = [&](std::size_t offset, auto number) {
        return ByteBuilder().text(content).number_at(offset, number).content();
    };
    const auto message = [](const std::string& bytes) { return message_of([&] { (void)opened(bytes); }); };
    EXPECT_EQ(message(changed(98, std::uint16_t{24})), "a.sur: at byte 98: SUR: 24 bits per point, expected 16 or 32");
    EXPECT_NE(message(changed(108, 0)).find("points"), std::string::npos);
    EXPECT_NE(message(changed(108, 1 << 30)).find("expected their product"), std::string::npos);
    EXPECT_NE(message(changed(128, std::numeric_limits<float>::quiet_NaN())).find("not a number"), std::string::npos);
    EXPECT_NE(message(changed(334, std::uint16_t{60000})).find("truncated"), std::string::npos);
}

TEST(Sur, StreamsWithAnImpossibleSizeAreRefused) {
    auto object = flagged(0);
    object.streams = 1;
    const auto content = sur_object(object);
    const auto huge = ByteBuilder().text(content).number_at(516, 0xffffffffu).content();
    EXPECT_NE(message_of([&] { (void)opened(huge); }).find("announce"), std::string::npos);
    const auto many = ByteBuilder().text(content).number_at(512, 0xffffffffu).content();
    EXPECT_NE(message_of([&] { (void)opened(many); }).find("compressed streams are announced"), std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::sur_test
