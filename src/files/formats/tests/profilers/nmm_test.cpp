// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "nmm_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::nmm_test {
namespace {

std::vector<Channel> channels_of(const Members& members) {
    return open(bytes::memory_source("a.zip", zip_archive(members)), {});
}

std::string& member(Members& members, const std::string& name) {
    for (auto& [key, content] : members)
        if (key == name) return content;
    throw std::runtime_error(name);
}

void replace(std::string& text, const std::string& what, const std::string& with) {
    text.replace(text.find(what), what.size(), with);
}

TEST(Nmm, EachScanIsAChannelWithItsOwnHeights) {
    const auto map = lopsided_heights(4, 3, units::nm);
    std::vector<double> first;
    for (const auto& channel : channels_of(nmm_members({map, map * 2.0, map * 3.0})))
        if (channel.info.is_height) first.push_back(topography::all_heights(channel.read())[0]);
    ASSERT_EQ(first.size(), 3u);
    EXPECT_DOUBLE_EQ(first[1], 2.0 * first[0]);
    EXPECT_DOUBLE_EQ(first[2], 3.0 * first[0]);
}

TEST(Nmm, IsReadByTheGeneralReader) {
    const TemporaryFolder folder;
    const auto map = lopsided_heights(4, 3, units::nm);
    EXPECT_DOUBLE_EQ(topography::all_heights(read(folder.write("groove.zip", zip_archive(nmm_members({map})))))[1],
                     map(0, 1));
}

TEST(Nmm, ALineHasOnePointMoreThanSteps) {
    const auto info = channels_of(nmm_members({lopsided_heights(11, 3, units::nm)})).at(0).info;
    EXPECT_EQ(info.shape, (std::vector<Index>{11, 3}));  // 5 µm in steps of 0.5 µm
    EXPECT_NEAR(info.size[0], 5.5 * units::um, 1e-18);
    EXPECT_EQ(info.metadata.acquisition_time, "Tue Jun 14 10:20:30 2022");
}

TEST(Nmm, OtherColumnsAreListedWithTheirUnits) {
    const auto channels = channels_of(nmm_members({lopsided_heights(4, 3, units::nm)}));
    ASSERT_EQ(channels.size(), 5u);
    EXPECT_EQ(channels[4].info.name, "scan 1: Ax");
    EXPECT_EQ(channels[4].info.unit, "V");
    EXPECT_FALSE(channels[4].info.is_height);
}

TEST(Nmm, IncompleteArchivesAreRefusedByTheMissingMember) {
    auto members = nmm_members({lopsided_heights(4, 3, units::nm)});
    members.pop_back();
    members.emplace_back("other.txt", "x");
    EXPECT_NE(message_of([&] { (void)channels_of(members); }).find("no member 'groove_1_3.dat'"), std::string::npos);
    members = nmm_members({lopsided_heights(4, 3, units::nm)});
    replace(member(members, "groove.dsc"), "Number of scans : 1", "Number of scans : 99");
    EXPECT_NE(message_of([&] { (void)channels_of(members); }).find("99 scans of 3 lines announced"), std::string::npos);
}

TEST(Nmm, LinesThatAreTooShortAreRefusedWithMemberAndLine) {
    auto members = nmm_members({lopsided_heights(4, 3, units::nm)});
    auto& data = member(members, "groove_1_2.dat");
    data.resize(data.find("\r\n") + 2);
    const auto message = message_of([&] { (void)channels_of(members).at(0).read(); });
    EXPECT_NE(message.find("groove_1_2.dat:2: NMM: the member ends after 1 of 4 points"), std::string::npos) << message;
}

TEST(Nmm, FilesWithoutHeightsAreRefused) {
    auto members = nmm_members({lopsided_heights(4, 1, units::nm)});
    replace(member(members, "groove_1_1.dsc"), "-Lz+Az", "Bz");
    const auto message = message_of([&] { (void)channels_of(members).at(0).read(); });
    EXPECT_NE(message.find("no column '-Lz+Az', got Lx, Ly, Lz, Ax, Bz"), std::string::npos) << message;
}

TEST(Nmm, FieldsInconsistentWithTheirStepsAreRefused) {
    auto members = nmm_members({lopsided_heights(4, 3, units::nm)});
    replace(member(members, "groove.dsc"), "Distance beetween points : 0.5", "Distance beetween points : 0.4");
    EXPECT_NE(message_of([&] { (void)channels_of(members); }).find("expected a whole number of steps"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::nmm_test
