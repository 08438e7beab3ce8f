// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::plux_test {
namespace {

const FormatSample& sample_named(const std::vector<FormatSample>& samples, const std::string& name) {
    for (const auto& sample : samples)
        if (sample.name == name) return sample;
    throw std::runtime_error(name);
}

std::string index_xml(const std::string& layers, const std::string& head = "") {
    return head +
           "<xml><GENERAL><IMAGE_SIZE_X>2</IMAGE_SIZE_X><IMAGE_SIZE_Y>2</IMAGE_SIZE_Y><FOV_X>1</FOV_X><FOV_Y>1</FOV_Y></GENERAL>" +
           layers + "</xml>";
}

std::string refusal(const Members& members) {
    return message_of([&] { (void)open(bytes::memory_source("a.plux", zip_archive(members)), {}); });
}

TEST(Plux, EveryLayerCanBeRead) {
    const auto samples = plux_samples();
    const auto channels = open(bytes::memory_source("a.plux", sample_named(samples, "second layer").content), {});
    ASSERT_EQ(channels.size(), 2u);
    const auto first = topography::all_heights(channels[0].read()),
               second = topography::all_heights(channels[1].read());
    EXPECT_NEAR(second[0], -3.0 * first[0], 1e-12);
}

TEST(Plux, KeepsDeviceAndDate) {
    const auto info = open(bytes::memory_source("a.plux", plux_samples()[0].content), {}).at(0).info;
    EXPECT_EQ(info.metadata.instrument.name, "S neox");
    EXPECT_EQ(info.metadata.acquisition_time, "Tue Mar 14 10:11:12 2023");
    EXPECT_EQ(info.metadata.attributes.at("objective"), "20X");
}

TEST(Plux, MissingLayersAreRefusedByName) {
    EXPECT_NE(refusal({{"index.xml", index_xml("<LAYER_0><FILENAME_Z>z.raw</FILENAME_Z></LAYER_0>")}})
                  .find("no member 'z.raw'"),
              std::string::npos);
    EXPECT_NE(refusal({{"index.xml", index_xml("")}}).find("names no layer"), std::string::npos);
}

TEST(Plux, ShortLayersAreRefusedWithTheOffsetOfTheirEnd) {
    const auto message = refusal({{"index.xml", index_xml("<LAYER_0><FILENAME_Z>z.raw</FILENAME_Z></LAYER_0>")},
                                  {"z.raw", std::string(12, '\0')}});
    EXPECT_NE(message.find("z.raw: at byte 12: plux: the file ends here"), std::string::npos) << message;
}

TEST(Plux, EntitiesAreRefused) {
    EXPECT_NE(refusal({{"index.xml", index_xml("", "<!DOCTYPE x [<!ENTITY a 'b'>]>")}})
                  .find("declarations of types or entities"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::plux_test
