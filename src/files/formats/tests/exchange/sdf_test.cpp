// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "counted_source.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "patched_sample.hpp"
#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::sdf_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

std::string sample_named(const std::string& name) {
    for (const auto& sample : sdf_samples())
        if (sample.name == name) return sample.content;
    ADD_FAILURE() << "no sample " << name;
    return {};
}
std::vector<Channel> opened(const std::string& content, const ReadOptions& options = {}) {
    return open(bytes::memory_source("a.sdf", content), options);
}
std::string refusal(const std::string& content) {
    return message_of([&] { (void)opened(content).at(0).read(); });
}

TEST(Sdf, HeaderAndTrailerAreKeptAsMetadata) {
    const auto info =
        opened(replaced(sample_named("text of floats"), "CheckType = 0", "CheckType = 0\r\nObjective = 50x"))
            .at(0)
            .info;
    EXPECT_EQ(info.metadata.instrument.name, "Maker");
    EXPECT_EQ(info.metadata.acquisition_time, "2010-01-04 08:53");
    EXPECT_EQ(info.metadata.attributes.at("modified"), "2010-03-05 13:53");
    EXPECT_EQ(info.metadata.attributes.at("OperatorName"), "Tom");
    EXPECT_EQ(info.metadata.attributes.at("Objective"), "50x");
    EXPECT_FALSE(info.metadata.attributes.contains("z_resolution"));  // -1 is unknown
    const auto binary = opened(sample_named("type 7")).at(0).info.metadata;
    EXPECT_EQ(binary.instrument.name, "Maker");
    EXPECT_EQ(binary.attributes.at("z_resolution"), "1e-09 m");
}

TEST(Sdf, TrailerMayBeTagged) {
    const auto content =
        replaced(sample_named("text of floats"), "OperatorName = Tom", "< OperatorName > Tom Jones < / OperatorName >");
    EXPECT_EQ(opened(content).at(0).info.metadata.attributes.at("OperatorName"), "Tom Jones");
}

TEST(Sdf, DateOfZerosIsIgnored) {
    const auto info = opened(replaced(sample_named("type 7"), "040120100853", "000000000000")).at(0).info;
    EXPECT_EQ(missing(info), (std::vector<std::string>{"date"}));
}

TEST(Sdf, HeaderLinesMayLackEqualsSignAndCapitals) {
    auto content = replaced(sample_named("text of integers"), "NumPoints = 5", "NUMPOINTS   5");
    content = replaced(content, "Zscale = 1e-09", "zscale\t1e-09");
    EXPECT_NEAR(std::get<HeightMap>(opened(content).at(0).read()).heights(0, 0), 1e-9, 1e-24);
}

TEST(Sdf, TextWithoutEndMarkIsReadIfItsLastNumberIsWhole) {
    auto content = sample_named("text of integers");
    content.erase(content.rfind('*', content.size() - 3));  // trailer and both marks
    EXPECT_EQ(std::get<HeightMap>(opened(content).at(0).read()).heights.isNaN().count(), 1);
    while (content.back() == '\n' || content.back() == ' ') content.pop_back();
    EXPECT_NE(refusal(content).find(
                  fmt::format("at byte {}: SDF: the heights end here, at point 15 of 5 × 3", content.size())),
              std::string::npos)
        << refusal(content);
}

TEST(Sdf, MoreHeightsThanAnnouncedAreRefused) {
    const auto content = sample_named("text of integers");
    EXPECT_NE(refusal(replaced(content, "NumProfiles = 3", "NumProfiles = 2")).find("more heights than 5 × 2"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(content, "BAD", "BAX")).find("'BAX' among the heights"), std::string::npos);
}

TEST(Sdf, AbsurdHeadersAreRefused) {
    const auto text = sample_named("text of floats");
    EXPECT_NE(
        refusal(replaced(text, "NumPoints = 5", "NumPoints = 4000000000")).find("is too short for 4000000000 × 3"),
        std::string::npos);
    EXPECT_NE(refusal(replaced(text, "NumPoints = 5", "NumPoints = five")).find("NumPoints is 'five'"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(text, "NumPoints = 5", "NumPoints = 0")).find("3 profiles of 0 points"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(text, "DataType = 7", "DataType = 8")).find("data type 8, expected 0 to 7"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(text, "Compression = 0", "Compression = 1")).find("compression 1"), std::string::npos);
    EXPECT_NE(refusal(replaced(text, "Zscale = 1e-09", "Zscale = 0")).find("Zscale is 0"), std::string::npos);
    EXPECT_NE(refusal(replaced(sample_named("type 7"), "ISO-1.0", "ISO-3.0")).find("at byte 5: SDF: version '3.0'"),
              std::string::npos);
}

TEST(Sdf, MissingScaleIsReported) {
    const auto content = replaced(sample_named("text of floats"), "Xscale = 1.0E-6\r\n", "");
    EXPECT_NE(refusal(content).find("`size`"), std::string::npos);
    EXPECT_EQ(std::get<HeightMap>(opened(content, {.size = {{1e-6, 4e-6}}}).at(0).read()).size[1], 4e-6);
}

TEST(Sdf, OpeningAGigabyteReadsTheHeaderOnly) {
    auto header = sample_named("type 7").substr(0, 81);
    header[42] = header[44] = '\0';
    header[43] = header[45] = '\x2c';  // 11264 × 11264
    const CountedSource file(header, header.size() + std::uint64_t{8} * 11264 * 11264);
    EXPECT_EQ(open(file.source(), {}).at(0).info.shape, (std::vector<Index>{11264, 11264}));
    EXPECT_LT(file.bytes(), 1u << 18);
}

TEST(SdfWriter, WritesTheBytesOfTheStandard) {
    HeightMap map{lopsided_heights(3, 2, 1e-9), {3e-6, 5e-6}, false, {}};
    map.metadata.instrument.name = "µScope number seven";
    map.metadata.acquisition_time = "2010-01-04T08:53:00";
    const TemporaryFolder folder;
    format_to_write("a.sdf").write(folder.path("a.sdf"), map);
    const auto bytes = bytes::read_file(folder.path("a.sdf"));
    ASSERT_EQ(bytes.size(), 8u + 10 + 24 + 4 + 32 + 3 + 6 * 8);
    EXPECT_EQ(bytes.substr(0, 42), "bISO-1.0Scope numb040120100853040120100853");
    EXPECT_EQ(bytes.substr(42, 4), std::string("\3\0\2\0", 4));
    EXPECT_EQ(bytes.substr(46, 24), bytes_of<double>({1e-6, 2.5e-6, 1.0}));
    EXPECT_EQ(bytes.substr(78, 3), std::string("\0\7\0", 3));
    EXPECT_EQ(bytes.substr(81, 16), bytes_of<double>({map.heights(0, 0), map.heights(1, 0)}));
}

TEST(SdfWriter, RefusesDataThatDoesNotFitTheFormat) {
    const Profile uneven{(Array1D(3) << 0.0, 1e-6, 3e-6).finished(), (Array1D(3) << 0.0, 1e-9, 0.0).finished(), {}};
    EXPECT_NE(
        message_of([&] { format_to_write("a.sdf").write("a.sdf", uneven); }).find("write it as .x3p, .nc or .csv"),
        std::string::npos);
    const LineScan longer{Array1D::Zero(65536), 1.0, false, {}};
    EXPECT_NE(message_of([&] { format_to_write("a.sdf").write("a.sdf", longer); }).find("at most 65535 points"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::sdf_test
