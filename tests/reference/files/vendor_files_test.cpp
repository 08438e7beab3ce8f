// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/io/channel.hpp"
#include "setae/io/format.hpp"
#include "setae/io/whole_file.hpp"

namespace setae::io {
namespace {

/// The entry of a file in expected/topography_files.json.
nlohmann::json expected_entry(const std::string& file) {
    auto text = read_file((tests::reference_data_folder() / "expected" / "topography_files.json").string());
    for (auto at = text.find(": NaN"); at != std::string::npos; at = text.find(": NaN", at)) text.replace(at, 5, ": null");
    for (const auto& entry : nlohmann::json::parse(text))
        if (entry.at("file") == file) return entry;
    return nullptr;
}

struct VendorFile {
    std::string file;
    double factor;  ///< from the entry's unit to metres
};

void PrintTo(const VendorFile& expected, std::ostream* stream) { *stream << expected.file; }

class VendorFiles : public testing::TestWithParam<VendorFile> {};

TEST_P(VendorFiles, HaveShapeSizeCornersAndHeightsOfAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, GetParam().file);
    const auto entry = expected_entry(GetParam().file);
    ASSERT_FALSE(entry.is_null());
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 1u);
    const auto& info = channels[0].info;
    EXPECT_EQ(info.shape, entry.at("shape").get<std::vector<Index>>());
    EXPECT_EQ(info.unit, entry.at("unit").get<std::string>());
    const auto sizes = entry.at("physical_sizes").get<std::vector<double>>();
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(info.size.at(i), sizes[i] * GetParam().factor, 1e-9 * info.size[i]);

    const auto map = std::get<topography::HeightMap>(channels[0].read());
    const Array2D heights = map.heights / GetParam().factor;
    const auto defined = static_cast<double>(heights.size() - heights.isNaN().count());
    const double mean = heights.isNaN().select(0.0, heights).sum() / defined;
    const double spread = std::sqrt(heights.isNaN().select(0.0, (heights - mean).square()).sum() / defined);
    const auto& computed = entry.at("peer_computed");
    EXPECT_EQ(heights.isNaN().count(), computed.at("n_undefined").get<Index>());
    EXPECT_NEAR(mean, computed.at("mean_valid").get<double>(), 1e-9 * std::abs(mean));
    EXPECT_NEAR(spread, computed.at("std_valid").get<double>(), 1e-6 * spread);
    const auto right = heights.rows() - 1, bottom = heights.cols() - 1;
    const double corners[] = {heights(0, 0), heights(0, bottom), heights(right, 0), heights(right, bottom)};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& corner = computed.at("corners_00_0m1_m10_m1m1").at(i);
        if (corner.is_null())
            EXPECT_TRUE(std::isnan(corners[i])) << i;
        else
            EXPECT_NEAR(corners[i], corner.get<double>(), 1e-12 * std::abs(mean)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, VendorFiles,
                         testing::Values(VendorFile{"topography/surfacetopography/sur-2.sur", units::mm}, VendorFile{"topography/surfacetopography/mnt-1.mnt", units::um}),
                         [](const auto& instance) { return instance.param.file.ends_with("mnt") ? "mnt_1" : "sur_2"; });

TEST(Sur, SpecialPointsOfARealFileAreUndefined) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/sur-2.sur");
    const auto heights = std::get<topography::HeightMap>(read(path.string())).heights;
    EXPECT_EQ(heights.isNaN().count(), 117);
    EXPECT_TRUE(std::isnan(heights(562, 483)));
    const double least = heights.isNaN().select(1.0, heights).minCoeff();
    EXPECT_NEAR(least / units::mm, 89120 * 1e-7, 1e-9);  // the header's least value, not two below it
}

/// The same surface as bcrf-1.bcrf, which holds it as float32 in µm, rows in the same order, behind a header of 2048 UTF-16 characters.
TEST(Mnt, HeightsAreThoseOfTheSameSurfaceInAnotherFormat) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/mnt-1.mnt");
    SETAE_REQUIRE_REFERENCE_DATA(twin, "topography/surfacetopography/bcrf-1.bcrf");
    const auto map = std::get<topography::HeightMap>(read(path.string()));
    const auto bytes = read_file(twin.string());
    constexpr std::size_t header = 2 * 2048;
    ASSERT_EQ(bytes.size(), header + 960 * 600 * sizeof(float));
    double worst = 0.0;
    for (Index j = 0; j < 600; ++j)
        for (Index i = 0; i < 960; ++i) {
            float height = 0.0f;
            std::memcpy(&height, bytes.data() + header + static_cast<std::size_t>(j * 960 + i) * sizeof(float), sizeof(float));
            worst = std::max(worst, std::abs(map.heights(i, j) - double{height} * units::um));
        }
    EXPECT_LE(worst / units::nm, 5e-5);  // half a count of 0.1 pm
}

TEST(Mnt, HeightsAreNoHundredThousandTimesTooLarge) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/mnt-1.mnt");
    const auto heights = std::get<topography::HeightMap>(read(path.string())).heights;
    EXPECT_NEAR(std::sqrt((heights - heights.mean()).square().mean()) / units::nm, 24.560210, 1e-5);
}

}  // namespace
}  // namespace setae::io
