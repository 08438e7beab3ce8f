// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/container_draft.hpp"
#include "setae/formats/format.hpp"

// The heights inside are compared in topographies_test.cpp.
namespace setae::formats::container_files_test {
namespace {

std::vector<std::string> codes(const std::vector<Alert>& alerts) {
    std::vector<std::string> found;
    for (const auto& alert : alerts) found.push_back(alert.code);
    return found;
}

/// A path that goes away with the test.
struct TemporaryPath {
    std::string path =
        (std::filesystem::temp_directory_path() / fmt::format("setae_container_files_{}.zip", getpid())).string();
    ~TemporaryPath() { std::filesystem::remove(path); }
};

TEST(UncdContainer, IndexIsReadCompletely) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/container-2.zip");
    const auto file = read_container(bytes::file_source(path.string()));
    EXPECT_TRUE(file.alerts.empty());
    EXPECT_EQ(file.generation, ContainerGeneration::yaml);
    EXPECT_EQ(file.container.versions.at("topobank"), "0.13.0");
    const auto& surface = file.container.surfaces.at(0);
    EXPECT_EQ(surface.description, "Demo UNCD data");
    ASSERT_EQ(surface.topographies.size(), 3u);
    EXPECT_EQ(surface.topographies[0].created_by->orcid, "0000-0001-8351-7336");
    EXPECT_EQ(surface.topographies[1].height_scale, 0.112075538798523);
    EXPECT_EQ(surface.topographies[1].measurement_date, "2018-04-05");
    EXPECT_EQ(surface.topographies[2].size, std::vector<double>{0.29878356133333334});
}

TEST(UncdContainer, CheckFindsTheRepeatedScale) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/container-2.zip");
    const auto report = check_container(bytes::file_source(path.string()));
    EXPECT_EQ(codes(report.alerts),
              (std::vector<std::string>{"NOT_IN_SCHEMA", "SCALE_TWICE"}));  // its surface has no name
    EXPECT_TRUE(report.differences.empty());
}

TEST(UncdContainer, UpgradeKeepsHeightsAndFilesUnchanged) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/container-2.zip");
    const auto source = bytes::file_source(path.string());
    const TemporaryPath written;
    ContainerDraft draft;
    add_container(draft, source);
    write_container(written.path, draft.container, draft.members);
    const auto before = open(path.string()), after = open(written.path);
    ASSERT_EQ(after.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE((topography::all_heights(before[i].read()) == topography::all_heights(after[i].read())).all()) << i;
    const auto& topographies = draft.container.surfaces[0].topographies;
    EXPECT_EQ(topographies[1].height_scale, std::nullopt);
    for (const auto& topography : topographies)
        EXPECT_EQ(container_member(bytes::file_source(written.path), topography.datafile.original).all(),
                  container_member(source, topography.datafile.original).all());
    EXPECT_EQ(codes(check_container(bytes::file_source(written.path)).alerts),
              std::vector<std::string>{"NOT_IN_SCHEMA"});
    // the copy that programs without a reader of the original take: 4.68792 nm with the scale applied once
    const auto copy =
        open(container_member(bytes::file_source(written.path), topographies[1].datafile.squeezed), {}).at(0).read();
    EXPECT_NEAR(std::sqrt(topography::all_heights(copy).square().mean()) / units::nm, 4.68792, 1e-4 * 4.68792);
}

TEST(IndexJsonContainer, CheckFindsNoProblem) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/containers/index_json.zip");
    const auto report = check_container(bytes::file_source(path.string()));
    EXPECT_EQ(report.file.generation, ContainerGeneration::skeleton);
    EXPECT_TRUE(report.alerts.empty());
    EXPECT_TRUE(report.differences.empty());
}

}  // namespace
}  // namespace setae::formats::container_files_test
