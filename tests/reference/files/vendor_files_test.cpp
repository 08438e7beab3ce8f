// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "expected_file.hpp"
#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"

namespace setae::formats::vendor_files_test {
namespace {

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
    EXPECT_EQ(channels[0].info.unit, entry.at("unit").get<std::string>());
    expect_entry_of(channels[0], entry, GetParam().factor);
}

INSTANTIATE_TEST_SUITE_P(Files, VendorFiles,
                         testing::Values(VendorFile{"topography/surfacetopography/sur-2.sur", units::mm},
                                         VendorFile{"topography/surfacetopography/mnt-1.mnt", units::um}),
                         [](const auto& instance) { return instance.param.file.ends_with("mnt") ? "mnt_1" : "sur_2"; });

TEST(Sur, SpecialPointsOfARealFileAreUndefined) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/sur-2.sur");
    const auto heights = std::get<topography::HeightMap>(read(path.string())).heights;
    EXPECT_EQ(heights.isNaN().count(), 117);
    EXPECT_TRUE(std::isnan(heights(562, 483)));
    const double least = heights.isNaN().select(1.0, heights).minCoeff();
    EXPECT_NEAR(least / units::mm, 89120 * 1e-7, 1e-9);  // the header's least value, not two below it
}

/// The same surface as bcrf-1.bcrf, which holds it as float32.
TEST(Mnt, IsTheSameSurfaceInAnotherFormat) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/mnt-1.mnt");
    SETAE_REQUIRE_REFERENCE_DATA(twin, "topography/surfacetopography/bcrf-1.bcrf");
    const auto map = std::get<topography::HeightMap>(read(path.string())),
               other = std::get<topography::HeightMap>(read(twin.string()));
    ASSERT_EQ(map.shape(), other.shape());
    EXPECT_LE((map.heights - other.heights).abs().maxCoeff() / units::nm, 5e-5);  // half a count of 0.1 pm
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(map.size[i] / other.size[i], 1.0, 1e-7);
}

TEST(Mnt, HeightsAreNotAHundredThousandTimesTooLarge) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/mnt-1.mnt");
    const auto heights = std::get<topography::HeightMap>(read(path.string())).heights;
    EXPECT_NEAR(std::sqrt((heights - heights.mean()).square().mean()) / units::nm, 24.560210, 1e-5);
}

}  // namespace
}  // namespace setae::formats::vendor_files_test
