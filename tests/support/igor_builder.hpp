// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "byte_builder.hpp"
#include "setae/core/arrays.hpp"

namespace setae::tests {

/// What an Igor binary wave of version 5 is to hold.
struct IgorContent {
    std::array<std::int32_t, 4> points{};
    std::array<double, 4> step{1.0, 1.0, 1.0, 1.0};
    std::string data_unit, lateral_unit;
    std::string long_data_unit = {};
    std::string note = {};
    std::vector<std::string> labels =
        {};  ///< of the points of the third dimension, or of the second where there is no third
    std::uint32_t created = 0;
    std::int16_t type = 2;  ///< of the numbers: 2 float, 4 double …
    std::string numbers = {};
    std::int32_t numbers_bytes = 0;  ///< announced; 0: those of `numbers`
};

/// The checksum at `at` made so that all 16-bit numbers of the first `bytes` sum to 0.
inline void put_checksum(ByteBuilder& file, std::size_t at, std::size_t bytes, std::endian order) {
    std::uint16_t sum = 0;
    for (std::size_t k = 0; k + 1 < bytes; k += 2) {
        const auto high = static_cast<unsigned char>(file.content()[k + (order == std::endian::big ? 0 : 1)]),
                   low = static_cast<unsigned char>(file.content()[k + (order == std::endian::big ? 1 : 0)]);
        sum = static_cast<std::uint16_t>(sum + 256 * high + low);
    }
    file.number_at(at, static_cast<std::uint16_t>(-sum));
}

/// BinHeader5, WaveHeader5, numbers, note, long unit and labels, as Technical Note 3 of WaveMetrics lists them.
[[nodiscard]] inline std::string igor_wave_5(std::endian order, const IgorContent& content) {
    const std::size_t labelled = content.points[2] > 0 ? 2 : 1,
                      label_bytes = content.labels.empty() ? 0 : 32 * (content.labels.size() + 1);
    std::uint32_t product = 1;  // of extents that damaged files exaggerate: it wraps around
    for (const auto along : content.points) product *= along > 0 ? static_cast<std::uint32_t>(along) : 1;
    const auto count = static_cast<std::int32_t>(product);
    ByteBuilder file(order);
    file.number<std::int16_t>(5).number<std::uint16_t>(0);
    file.number(content.numbers_bytes > 0 ? 320 + content.numbers_bytes
                                          : static_cast<std::int32_t>(320 + content.numbers.size()))
        .number<std::int32_t>(0)
        .number(static_cast<std::int32_t>(content.note.size()));
    file.number(static_cast<std::int32_t>(content.long_data_unit.size()));
    for (int k = 0; k < 4; ++k) file.number<std::int32_t>(0);
    for (std::size_t k = 0; k < 4; ++k) file.number(static_cast<std::int32_t>(k == labelled ? label_bytes : 0));
    file.pad_to(64);
    file.number<std::uint32_t>(0)
        .number(content.created)
        .number(content.created)
        .number(count)
        .number(content.type)
        .pad_to(64 + 28);
    file.text("wave0", 32).pad_to(64 + 68);
    for (const auto along : content.points) file.number(along);
    for (const auto step : content.step) file.number(step);
    for (int k = 0; k < 4; ++k) file.number(0.0);
    file.text(content.data_unit, 4).text(content.lateral_unit, 4).text(content.lateral_unit, 4).pad_to(384);
    put_checksum(file, 2, 384, order);
    file.text(content.numbers).text(content.note).text(content.long_data_unit);
    if (label_bytes > 0) file.text("", 32);
    for (const auto& label : content.labels) file.text(label, 32);
    return file.content();
}

}  // namespace setae::tests
