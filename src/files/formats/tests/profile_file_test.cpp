// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/profile_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::profile_file_test {
namespace {

using topography::Profile;

Profile traced() {
    Profile profile;
    const Index n = 40;
    profile.positions = Array1D::LinSpaced(n, 0.0, 1.7e-8);
    profile.heights = 1e-9 * (profile.positions * 7.3e8).sin() / 3.0;
    profile.standard_error = 1e-11 * (1.0 + (profile.positions * 1e9).cos().square());
    profile.response = topography::TraceResponse{2.1e-10 / 3.0, 1.4e-10 / 7.0, 5.5e-11 / 3.0, 3.2e-31 / 7.0};
    profile.metadata.name = "uncd 03, second";
    profile.metadata.acquisition_time = "2024-03-01 10:15:00";
    profile.metadata.instrument = {"Titan: 300 kV", "tem", {}, {}, 1.1e-10 / 3.0};
    profile.metadata.attributes = {{"foil_thickness", "1.2e-08 m"},
                                   {"rotation", "-0.0213 rad"},
                                   {"reentrant_share", "0.013"},
                                   {"anchors", "a.json"},
                                   {"remark", ""}};
    return profile;
}

Profile read_back(const std::string& text) {
    return std::get<Profile>(open(bytes::memory_source("p.csv", text), {}).at(0).read());
}

void expect_same(const Profile& a, const Profile& b) {
    ASSERT_EQ(a.positions.size(), b.positions.size());
    EXPECT_TRUE((a.positions == b.positions).all());
    EXPECT_TRUE((a.heights == b.heights).all());
    ASSERT_EQ(a.standard_error.size(), b.standard_error.size());
    EXPECT_TRUE((a.standard_error == b.standard_error).all());
    ASSERT_EQ(a.response.has_value(), b.response.has_value());
    if (a.response) {
        EXPECT_EQ(a.response->blur, b.response->blur);
        EXPECT_EQ(a.response->smoothing_length, b.response->smoothing_length);
        EXPECT_EQ(a.response->step, b.response->step);
        EXPECT_EQ(a.response->noise_density, b.response->noise_density);
    }
    EXPECT_EQ(a.metadata.name, b.metadata.name);
    EXPECT_EQ(a.metadata.acquisition_time, b.metadata.acquisition_time);
    EXPECT_EQ(a.metadata.instrument.name, b.metadata.instrument.name);
    EXPECT_EQ(a.metadata.instrument.type, b.metadata.instrument.type);
    EXPECT_EQ(a.metadata.instrument.tip_radius, b.metadata.instrument.tip_radius);
    EXPECT_EQ(a.metadata.instrument.resolution, b.metadata.instrument.resolution);
    EXPECT_EQ(a.metadata.attributes, b.metadata.attributes);
}

/// The file with one line replaced; lines count from 1.
std::string with_line(std::size_t line, const std::string& replacement) {
    std::istringstream lines(as_profile_file(traced()));
    std::string text, current;
    for (std::size_t i = 1; std::getline(lines, current); ++i) text += (i == line ? replacement : current) + "\n";
    return text;
}

std::size_t line_of(const std::string& key) {
    std::istringstream lines(as_profile_file(traced()));
    std::string current;
    for (std::size_t i = 1; std::getline(lines, current); ++i)
        if (current.starts_with("# " + key + ":")) return i;
    return 0;
}

TEST(ProfileFile, IsReadBackToTheLastBit) {
    const auto text = as_profile_file(traced());
    expect_same(read_back(text), traced());
    const TemporaryFolder folder;
    write_profile(folder.path("p.csv"), traced());
    const auto measurement = read(folder.path("p.csv"));
    ASSERT_TRUE(std::holds_alternative<Profile>(measurement));  // although its steps are equal
    expect_same(std::get<Profile>(measurement), traced());
    EXPECT_EQ(as_profile_file(std::get<Profile>(measurement)), text);
}

TEST(ProfileFile, StoresProfilesWithoutErrorsOrResponse) {
    auto plain = traced();
    plain.standard_error = Array1D();
    plain.response.reset();
    plain.metadata.name.clear();
    plain.metadata.attributes.clear();
    expect_same(read_back(as_profile_file(plain)), plain);
}

TEST(ProfileFile, DamagedHeadLinesAreNamed) {
    const auto expect = [](const std::string& key, const std::string& replacement, const std::string& named) {
        const auto line = line_of(key);
        ASSERT_GT(line, 0u) << key;
        const auto message = message_of([&] { (void)read_back(with_line(line, replacement)); });
        EXPECT_NE(message.find(fmt::format("p.csv:{}", line)), std::string::npos) << message;
        EXPECT_NE(message.find(named), std::string::npos) << message;
    };
    expect("version", "# version: 7", "version '7'");
    expect("blur", "# blur 1e-10 m", "not 'key: value'");
    expect("blur", "# blur: 1e-10", "blur");
    expect("blur", "# blur: -1e-10 m", "expected a number >= 0");
    expect("step", "# step: 0 m", "expected a number > 0");
    expect("noise_density", "# noise_density: 1e-30 m2", "noise_density");
    expect("foil_thickness", "# foil_thickness: thin", "foil_thickness");
    expect("rotation", "# blur: 1e-10 m", "given twice");
    expect("reentrant_share", "# : 3", "not 'key: value'");
}

TEST(ProfileFile, IncompleteResponseIsRefused) {
    const auto message = message_of([&] { (void)read_back(with_line(line_of("step"), "")); });
    EXPECT_NE(message.find("without 'step'"), std::string::npos) << message;
    EXPECT_NE(message.find("p.csv:"), std::string::npos) << message;
}

TEST(ProfileFile, RefusesBadErrorsAndColumns) {
    const std::string head = "# format: setae profile\n# version: 1\n";
    EXPECT_THROW((void)read_back(head + "x [m],h [m],standard_error [m]\n0,1,1\n1,2,-1\n"), FormatError);
    EXPECT_THROW((void)read_back(head + "x [m],h [m],colour [m]\n0,1,1\n1,2,1\n"), FormatError);
    EXPECT_THROW((void)read_back(head + "x [m],h [m]\n0,1\n"), FormatError);
    EXPECT_THROW((void)read_back("# format: setae profile\nx [m],h [m]\n0,1\n1,2\n"), FormatError);
    EXPECT_NO_THROW((void)read_back(head + "x [nm],h [nm]\n0,1\n1,2\n"));
}

TEST(ProfileFile, RefusesToWriteWhatCannotBeReadBack) {
    for (const char* key : {"blur", "a:b", "", " a", "a\nb"}) {
        auto profile = traced();
        profile.metadata.attributes[key] = "1";
        EXPECT_THROW((void)as_profile_file(profile), InvalidArgument) << key;
    }
    auto profile = traced();
    profile.metadata.attributes["foil_thickness"] = "12";
    EXPECT_THROW((void)as_profile_file(profile), InvalidArgument);
}

TEST(TextTable, ReadsAThirdColumnOfStandardErrors) {
    const auto profile = read_back("x [nm];height [nm];Standard_Error [pm]\n0;1;10\n1;2;20\n3;1;30\n");
    ASSERT_EQ(profile.standard_error.size(), 3);
    EXPECT_NEAR(profile.standard_error[2], 30e-12, 1e-24);
    EXPECT_NEAR(profile.heights[1], 2e-9, 1e-22);
    const auto reversed = read_back("x [nm];h [nm];standard_error [nm]\n3;1;10\n1;2;20\n0;1;30\n");
    EXPECT_NEAR(reversed.standard_error[0], 30e-9, 1e-21);
    const auto message = message_of([] { (void)read_back("x [nm];h [nm];standard_error\n0;1;10\n1;2;20\n"); });
    EXPECT_NE(message.find("no unit"), std::string::npos) << message;
}

TEST(ProfileFormat, KeysAreInTheDocumentation) {
    std::ifstream file("docs/reference/profile-format.md");
    std::stringstream text;
    text << file.rdbuf();
    for (const auto& key : profile_keys()) {
        if (key.name == "format" || key.name == "version") continue;
        EXPECT_NE(text.str().find(fmt::format("| {} |", key.name)), std::string::npos) << key.name;
        EXPECT_NE(text.str().find(key.meaning), std::string::npos) << key.name;
    }
}

}  // namespace
}  // namespace setae::formats::tests::profile_file_test
