// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference_data.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The entry of a file's channel in expected/topography_files.json; null where there is none.
inline nlohmann::json expected_entry(const std::string& file, std::size_t channel = 0) {
    auto text = bytes::read_file((tests::reference_data_folder() / "expected" / "topography_files.json").string());
    for (auto at = text.find(": NaN"); at != std::string::npos; at = text.find(": NaN", at))
        text.replace(at, 5, ": null");
    for (const auto& entry : nlohmann::json::parse(text))
        if (entry.at("file") == file && entry.at("channel_index") == channel) return entry;
    return nullptr;
}

/// Sizes of an entry in units of `factor` metres, where the measurement is of the entry's kind: of a profile it has the
/// extent.
inline void expect_size_of(const Channel& channel, const nlohmann::json& entry, double factor) {
    const auto& sizes = entry.at("physical_sizes");
    if (sizes.is_null()) return;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        EXPECT_NEAR(channel.info.size.at(i) / factor, sizes[i].get<double>(), 1e-9 * sizes[i].get<double>())
            << "size " << i;
}

/// Shape, undefined points, range, mean, deviation and corners are those of the entry, whose heights are `factor`
/// metres.
inline void expect_heights_of(const Channel& channel, const nlohmann::json& entry, double factor) {
    ASSERT_FALSE(entry.is_null()) << "no entry of this file";
    EXPECT_EQ(channel.info.shape, entry.at("shape").get<std::vector<Index>>());
    const auto measurement = channel.read();
    const Array1D heights = topography::all_heights(measurement) / factor;
    const auto defined = !heights.isNaN();
    const auto count = static_cast<double>(defined.count());
    const double mean = defined.select(heights, 0.0).sum() / count;
    const auto& computed = entry.at("peer_computed");
    const double least = computed.at("min").get<double>(), greatest = computed.at("max").get<double>();
    const double tolerance = 1e-9 * std::max(std::abs(least), std::abs(greatest));
    EXPECT_EQ(heights.size() - defined.count(), computed.at("n_undefined").get<Index>());
    EXPECT_NEAR(defined.select(heights, INFINITY).minCoeff(), least, tolerance);
    EXPECT_NEAR(defined.select(heights, -INFINITY).maxCoeff(), greatest, tolerance);
    EXPECT_NEAR(mean, computed.at("mean_valid").get<double>(), tolerance);
    const double deviation = computed.at("std_valid").get<double>();
    EXPECT_NEAR(std::sqrt(defined.select((heights - mean).square(), 0.0).sum() / count), deviation,
                std::max(1e-6 * deviation, 1e-12 * std::abs(mean)));
    if (!computed.contains("corners_00_0m1_m10_m1m1")) return;
    const auto& map = std::get<topography::HeightMap>(measurement);
    const Index right = map.heights.rows() - 1, bottom = map.heights.cols() - 1;
    const std::array corners{map.heights(0, 0), map.heights(0, bottom), map.heights(right, 0),
                             map.heights(right, bottom)};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto& corner = computed.at("corners_00_0m1_m10_m1m1").at(k);
        if (corner.is_null()) EXPECT_TRUE(std::isnan(corners[k])) << "corner " << k;
        else EXPECT_NEAR(corners[k] / factor, corner.get<double>(), tolerance) << "corner " << k;
    }
}

inline void expect_entry_of(const Channel& channel, const nlohmann::json& entry, double factor) {
    ASSERT_NO_FATAL_FAILURE(expect_heights_of(channel, entry, factor));
    expect_size_of(channel, entry, factor);
}

}  // namespace setae::formats
