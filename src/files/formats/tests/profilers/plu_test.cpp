// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "plu_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::plu_test {
namespace {

std::vector<Channel> channels_of(const std::string& content) {
    return open(bytes::memory_source("a.plu", content), {});
}

TEST(Plu, ReadsTimeAndInstrument) {
    const auto metadata = channels_of(plu_file(3, {lopsided_heights(4, 3, 1.0)})).at(0).info.metadata;
    EXPECT_EQ(metadata.acquisition_time, "Fri Mar 10 16:35:59 2023");
    EXPECT_EQ(metadata.instrument.name, "PLu neox");
    EXPECT_EQ(metadata.attributes.at("comment"), "lapped");
}

TEST(Plu, ProfilesAreLineScans) {
    const auto measurement = channels_of(plu_file(1, {lopsided_heights(5, 1, 1.0)})).at(0).read();
    const auto* scan = std::get_if<topography::LineScan>(&measurement);
    ASSERT_NE(scan, nullptr);
    EXPECT_DOUBLE_EQ(scan->size, 7.5 * units::um);
}

TEST(Plu, OnlyTheMarkerIsUndefined) {
    auto heights = lopsided_heights(3, 2, 1.0);
    heights(0, 1) = undefined;  // written as 1000001
    heights(2, 0) = 1000000.0;
    const auto read = topography::all_heights(channels_of(plu_file(3, {heights})).at(0).read());
    EXPECT_EQ(read.isNaN().count(), 1);
    EXPECT_DOUBLE_EQ(read[4], 1.0);
}

TEST(Plu, FindsLayersAfterPicturesOfEarlierLayers) {
    const auto first = lopsided_heights(4, 3, 1.0);
    const auto channels = channels_of(plu_file(3, {first, first + 1.0, first + 2.0}));
    ASSERT_EQ(channels.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(topography::all_heights(channels[k].read())[0], (first(0, 0) + static_cast<double>(k)) * units::um,
                    1e-12)
            << k;
}

TEST(Plu, OldVersionsWithoutLayerCountHaveOneLayer) {
    auto content = plu_file(3, {lopsided_heights(4, 3, 1.0)});
    content[489] = content[490] = '\0';
    const auto channels = channels_of(content);
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "Sensofar");
}

TEST(Plu, PicturesAndThicknessesAreListed) {
    for (const auto& [kind, unit] : {std::pair{0u, ""}, {5u, "µm"}}) {
        const auto info = channels_of(plu_file(kind, {lopsided_heights(4, 3, 1.0)})).at(0).info;
        EXPECT_FALSE(info.is_height) << kind;
        EXPECT_EQ(info.unit, unit);
    }
}

TEST(Plu, OtherMeasurementsAreRefusedByName) {
    const auto message = message_of([] { (void)channels_of(plu_file(2, {lopsided_heights(4, 3, 1.0)})); });
    EXPECT_NE(message.find("PLu: a measurement of several profiles, expected a topography or a profile"),
              std::string::npos)
        << message;
}

TEST(Plu, TextThatBeginsWithADateIsNotPlu) {
    const auto& format = detect_format(
        bytes::memory_source("log.txt", "Fri Mar 10 16:35:59 2023\n1 2\n2 3\n3 4\n" + std::string(600, ' ')));
    EXPECT_NE(format.identifier, "plu");
}

}  // namespace
}  // namespace setae::formats::tests::plu_test
