// SPDX-License-Identifier: GPL-3.0-or-later
#include "igor_wave.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/bytes/cursor.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

// WaveMetrics, Technical Note 3, "Igor Binary Format". Version 5: BinHeader5 (64 bytes), WaveHeader5 (320), numbers,
// formula, note, long units of the data and of each dimension, labels of each dimension. Version 2: BinHeader2 (16),
// WaveHeader2 (110), numbers, 16 bytes, note.
namespace setae::formats {
namespace {

constexpr std::uint64_t bin_header_2 = 16, wave_header_2 = 110, padding_2 = 16, bin_header_5 = 64, wave_header_5 = 320,
                        label_bytes = 32;
constexpr std::uint64_t longest_text_of_igor = 1 << 24;

std::uint64_t headers_bytes(int version) {
    switch (version) {
        case 1: return 8 + wave_header_2;
        case 2: return bin_header_2 + wave_header_2;
        case 3: return 20 + wave_header_2;
        case 5: return bin_header_5 + wave_header_5;
        default: return 0;
    }
}

/// A size in the header, which must be inside the file.
std::uint64_t size_of_part(bytes::Cursor& cursor) {
    const auto value = cursor.number<std::int32_t>();
    if (value < 0 || static_cast<std::uint64_t>(value) > cursor.source().size)
        cursor.fail(
            fmt::format("a part of {} bytes in a file of {}; it is truncated or damaged", value, cursor.source().size));
    return static_cast<std::uint64_t>(value);
}

Sample sample_of(bytes::Cursor& cursor) {
    const auto type = cursor.number<std::int16_t>();
    switch (type) {
        case 0x02: return Sample::float32;
        case 0x04: return Sample::float64;
        case 0x08: return Sample::int8;
        case 0x10: return Sample::int16;
        case 0x20: return Sample::int32;
        case 0x48: return Sample::uint8;
        case 0x50: return Sample::uint16;
        case 0x60: return Sample::uint32;
        default:
            cursor.fail(fmt::format(
                "numbers of type {}, expected real ones (2 or 4 floats, 8, 16, 32 integers, with 64 unsigned)", type));
    }
}

std::uint64_t points_along(bytes::Cursor& cursor) {
    const auto value = cursor.number<std::int32_t>();
    if (value < 0) cursor.fail(fmt::format("{} points along a dimension", value));
    return static_cast<std::uint64_t>(value);
}

/// The parts after the numbers, in sequence, each refused if incomplete.
class IgorParts {
public:
    IgorParts(const bytes::Source& source, std::uint64_t at) : cursor_(source, "Igor", at) {}

    std::string text(std::uint64_t bytes) {
        if (bytes > longest_text_of_igor)
            cursor_.fail(fmt::format("a text of {} bytes, expected at most {}", bytes, longest_text_of_igor));
        return bytes::decoded(cursor_.bytes(bytes), bytes::Encoding::detect);
    }
    void skip(std::uint64_t bytes) { cursor_.skip(bytes); }
    /// The first label is that of the dimension, the others are those of its points.
    std::vector<std::string> labels(std::uint64_t bytes, std::uint64_t points) {
        const auto all = cursor_.bytes(bytes);
        std::vector<std::string> names;
        for (std::uint64_t k = 1; k <= points && (k + 1) * label_bytes <= bytes; ++k)
            names.push_back(
                bytes::decoded(std::string(all.substr(k * label_bytes, label_bytes).c_str()), bytes::Encoding::detect));
        return names;
    }

private:
    bytes::Cursor cursor_;
};

void require_numbers(const IgorWave& wave, std::uint64_t announced, const bytes::Source& source) {
    const auto bytes = bytes_of(wave.sample);
    std::uint64_t points = 1;
    for (const auto along : wave.points) {
        if (along == 0) break;
        if (along > (source.size / bytes + 1) / points)
            throw FormatError(
                source.name, {.offset = source.size},
                fmt::format(
                    "Igor: the file ends here, but the wave announces {} × {} × {} × {} points; it is truncated or "
                    "damaged",
                    wave.points[0], wave.points[1], wave.points[2], wave.points[3]));
        points *= along;
    }
    if (points * bytes > source.size - wave.data_at)
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format("Igor: the file ends here, expected the end of its numbers at byte {}; it is truncated",
                        wave.data_at + points * bytes));
    if (points * bytes > announced)
        throw FormatError(source.name, {.offset = 4},
                          fmt::format("Igor: {} bytes are announced for numbers of {}", announced, points * bytes));
}

IgorWave wave_of_version_2(bytes::Cursor& cursor, const bytes::Source& source) {
    IgorWave wave{.version = 2};
    wave.data_at = bin_header_2 + wave_header_2;
    const auto wave_bytes = size_of_part(cursor), note_bytes = size_of_part(cursor);
    cursor.seek(bin_header_2);
    wave.sample = sample_of(cursor);
    cursor.skip(4);
    wave.name = cursor.text(20);
    cursor.skip(8);
    wave.data_unit = cursor.text(4);
    wave.units[0] = cursor.text(4);
    wave.points[0] = points_along(cursor);
    cursor.skip(2);
    wave.step[0] = cursor.number<double>();
    cursor.seek(bin_header_2 + 96);
    wave.created = cursor.number<std::uint32_t>();
    require_numbers(wave, wave_bytes - std::min(wave_bytes, wave_header_2 + padding_2), source);
    IgorParts parts(source, bin_header_2 + wave_bytes);
    wave.note = parts.text(note_bytes);
    return wave;
}

IgorWave wave_of_version_5(bytes::Cursor& cursor, const bytes::Source& source) {
    IgorWave wave{.version = 5};
    wave.data_at = bin_header_5 + wave_header_5;
    cursor.skip(2);  // checksum
    const auto wave_bytes = size_of_part(cursor), formula_bytes = size_of_part(cursor),
               note_bytes = size_of_part(cursor), unit_bytes = size_of_part(cursor);
    std::array<std::uint64_t, 4> long_unit_bytes{}, labels_bytes{};
    for (auto& bytes : long_unit_bytes) bytes = size_of_part(cursor);
    for (auto& bytes : labels_bytes) bytes = size_of_part(cursor);
    cursor.seek(bin_header_5 + 4);
    wave.created = cursor.number<std::uint32_t>();
    cursor.seek(bin_header_5 + 16);
    wave.sample = sample_of(cursor);
    cursor.skip(2 + 6 + 2);
    wave.name = cursor.text(32);
    cursor.skip(8);
    for (auto& along : wave.points) along = points_along(cursor);
    for (auto& step : wave.step) step = cursor.number<double>();
    cursor.skip(4 * 8);  // value of the first point along each dimension
    wave.data_unit = cursor.text(4);
    for (auto& unit : wave.units) unit = cursor.text(4);
    require_numbers(wave, wave_bytes - std::min(wave_bytes, wave_header_5), source);
    IgorParts parts(source, bin_header_5 + wave_bytes);
    parts.skip(formula_bytes);
    wave.note = parts.text(note_bytes);
    if (unit_bytes > 0) wave.data_unit = parts.text(unit_bytes);
    for (std::size_t k = 0; k < 4; ++k)
        if (long_unit_bytes[k] > 0) wave.units[k] = parts.text(long_unit_bytes[k]);
    for (std::size_t k = 0; k < 4; ++k) wave.labels[k] = parts.labels(labels_bytes[k], wave.points[k]);
    return wave;
}

}  // namespace

std::uint64_t IgorWave::count() const {
    std::uint64_t product = 1;
    for (const auto along : points) {
        if (along == 0) break;
        product *= along;
    }
    return points[0] == 0 ? 0 : product;
}

std::optional<std::endian> igor_order(std::string_view head) {
    for (const auto order : {std::endian::little, std::endian::big}) {
        if (head.size() < 2) return std::nullopt;
        const auto bytes = headers_bytes(bytes::load<std::int16_t>(head.data(), order));
        if (bytes == 0 || head.size() < bytes) continue;
        std::uint16_t sum = 0;
        for (std::size_t at = 0; at + 1 < bytes; at += 2)
            sum = static_cast<std::uint16_t>(sum + bytes::load<std::uint16_t>(head.data() + at, order));
        if (sum == 0) return order;
    }
    return std::nullopt;
}

IgorWave igor_wave(const bytes::Source& source) {
    const auto order = igor_order(source.head(bin_header_5 + wave_header_5));
    if (!order)
        throw FormatError(source.name, {.offset = 0},
                          "Igor: the checksum of the headers is wrong; the file is truncated or damaged");
    bytes::Cursor cursor(source, "Igor", 0, *order);
    const auto version = cursor.number<std::int16_t>();
    if (version != 2 && version != 5)
        cursor.fail(
            fmt::format("a binary wave of version {}, expected 2 or 5; save it again with a newer Igor Pro", version));
    auto wave = version == 2 ? wave_of_version_2(cursor, source) : wave_of_version_5(cursor, source);
    wave.order = *order;
    return wave;
}

}  // namespace setae::formats
