// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "format_samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

namespace setae::formats::tests::formats_test {

namespace {

class FormatSamples : public testing::TestWithParam<FormatSample> {};

bytes::Source source_of(const FormatSample& sample) {
    return bytes::memory_source(sample.format + " sample", sample.content);
}

TEST_P(FormatSamples, AreDetected) { EXPECT_EQ(detect_format(source_of(GetParam())).identifier, GetParam().format); }

TEST_P(FormatSamples, GiveShapeAndSizeBeforeHeightsAreRead) {
    const auto channel = open(source_of(GetParam()), GetParam().options).at(GetParam().channel);
    EXPECT_EQ(channel.info.shape, GetParam().shape);
    EXPECT_EQ(channel.info.format, GetParam().member_format.empty() ? GetParam().format : GetParam().member_format);
    EXPECT_TRUE(channel.info.is_height);
    EXPECT_FALSE(channel.info.unit.empty());
    EXPECT_EQ(channel.info.orientation.empty(), GetParam().shape.size() == 1) << channel.info.orientation;
    ASSERT_EQ(channel.info.size.size(), GetParam().size.size());
    for (std::size_t i = 0; i < GetParam().size.size(); ++i)
        EXPECT_NEAR(channel.info.size[i], GetParam().size[i], 1e-12 * GetParam().size[i]);
}

TEST_P(FormatSamples, GiveTheExpectedHeights) {
    const auto measurement = open(source_of(GetParam()), GetParam().options).at(GetParam().channel).read();
    const auto& expected = GetParam().heights;
    const Array1D heights = topography::all_heights(measurement),
                  wanted = Eigen::Map<const Array1D>(expected.data(), expected.size());
    ASSERT_EQ(heights.size(), wanted.size());
    const double tolerance = GetParam().tolerance * wanted.isNaN().select(0.0, wanted.abs()).maxCoeff();
    for (Index i = 0; i < heights.size(); ++i) {
        ASSERT_EQ(std::isnan(heights[i]), std::isnan(wanted[i])) << "point " << i;
        if (std::isnan(wanted[i])) continue;
        ASSERT_NEAR(heights[i], wanted[i], tolerance) << "point " << i;
    }
}

TEST_P(FormatSamples, GiveTheSameHeightsByBandsOfLines) {
    const auto channel = open(source_of(GetParam()), GetParam().options).at(GetParam().channel);
    const auto map = tiled(channel);
    if (!map) return;
    const auto whole = std::get<topography::HeightMap>(channel.read());
    EXPECT_FALSE(whole.periodic);
    for (const Index first : {Index{0}, map->ny / 2}) {
        const auto count = (map->ny + 1) / 2;
        if (first + count > map->ny) continue;
        const Array2D band = map->lines(first, count), wanted = whole.heights.middleCols(first, count);
        ASSERT_EQ(band.rows(), map->nx);
        EXPECT_TRUE((band == wanted || (band.isNaN() && wanted.isNaN())).all()) << "lines from " << first;
    }
    EXPECT_THROW((void)map->lines(map->ny, 1), InvalidArgument);
}

TEST(Formats, MajorityOfMapsCanBeReadByBandsOfLines) {
    int maps = 0, tiled_maps = 0;
    for (const auto& sample : format_samples()) {
        const auto channel = open(source_of(sample), sample.options).at(sample.channel);
        maps += channel.info.shape.size() == 2;
        tiled_maps += tiled(channel).has_value();
    }
    EXPECT_GT(2 * tiled_maps, maps);
}

/// Opens and reads all channels; the text of the error, or empty.
std::string error_of(const FormatSample& sample, const std::string& content) {
    try {
        for (const auto& channel : open(bytes::memory_source("cut", content), sample.options))
            if (channel.info.is_height || !channel.info.alerts.empty()) (void)channel.read();
    } catch (const FormatError& error) {
        return error.what();
    }
    return {};
}

TEST_P(FormatSamples, AreRefusedWithTheOffsetWhereTheyAreCut) {
    constexpr std::size_t cuts = 64;
    for (std::size_t k = 0; k < cuts; ++k) {
        const auto length = GetParam().content.size() * k / cuts;
        std::string error;
        try {
            error = error_of(GetParam(), GetParam().content.substr(0, length));
        } catch (const InvalidArgument& missing) {  // the rest may be a complete text without size or unit
            EXPECT_TRUE(GetParam().may_lose_its_end) << "cut at " << length << ": " << missing.what();
            continue;
        } catch (const Error& other) {
            ADD_FAILURE() << "cut at " << length << ": " << other.what();
            continue;
        }
        if (GetParam().may_lose_its_end && error.empty()) continue;
        const bool has_place = error.find("at byte ") != std::string::npos || error.starts_with("cut:");
        EXPECT_TRUE(has_place) << "cut at " << length << " of " << GetParam().content.size() << ": '" << error << "'";
    }
}

INSTANTIATE_TEST_SUITE_P(All, FormatSamples, testing::ValuesIn(format_samples()), [](const auto& instance) {
    auto name = instance.param.format + "_" + instance.param.name;
    for (auto& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

TEST(Formats, EachHasASampleWithANonSquareMapOrALine) {
    std::set<std::string> seen;
    for (const auto& sample : format_samples())
        if (sample.shape.size() == 1 || sample.shape[0] != sample.shape[1]) seen.insert(sample.format);
    seen.insert("hgt");  // a tile has 3 MB or more, too much for every test: formats/hgt_test.cpp has one
    for (const auto& format : formats()) EXPECT_TRUE(seen.contains(format.identifier)) << format.identifier;
}

TEST(Formats, EachHasADescription) {
    std::set<std::string> identifiers;
    for (const auto& format : formats()) {
        EXPECT_TRUE(identifiers.insert(format.identifier).second) << format.identifier << " twice";
        for (const auto* text :
             {&format.name, &format.extensions, &format.description, &format.heights, &format.reference}) {
            EXPECT_FALSE(text->empty()) << format.identifier;
            EXPECT_FALSE(text->ends_with('.')) << format.identifier << ": " << *text;
        }
    }
}

TEST(Formats, TableIsComplete) {
    for (const auto& format : formats()) {
        EXPECT_FALSE(format.identifier.empty() || format.name.empty() || format.extensions.empty() ||
                     format.description.empty() || format.reference.empty())
            << format.identifier;
        EXPECT_TRUE(format.detect && format.open) << format.identifier;
    }
}

}  // namespace
}  // namespace setae::formats::tests::formats_test
