// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/force_curve_formats.hpp"

// Igor binary wave, version 5: BinHeader5 (64 bytes), WaveHeader5 (320 bytes), numbers, formula, note, units and labels
// of dimensions. Source: WaveMetrics, Technical Note 3, "Igor Binary Format".
namespace setae::tables {
namespace {

constexpr std::uint64_t header_bytes = 384, wave_begins = 64, label_bytes = 32;

/// Layout by the headers.
struct Wave {
    std::endian order = std::endian::little;
    std::uint64_t rows = 0, columns = 0, number_bytes = 0;
    std::uint64_t note_at = 0, note_bytes = 0, labels_at = 0, labels_bytes = 0;
};

std::int32_t integer(const std::string& head, std::size_t at, std::endian order) {
    return bytes::load<std::int32_t>(head.data() + at, order);
}

/// A size in the header, which must be inside the file.
std::uint64_t size_at(const std::string& head, std::size_t at, std::endian order, const bytes::Source& source) {
    const auto value = integer(head, at, order);
    if (value < 0 || static_cast<std::uint64_t>(value) > source.size)
        throw FormatError(
            source.name, {.offset = at},
            fmt::format("a size of {} bytes in a file of {}; it is damaged or truncated", value, source.size));
    return static_cast<std::uint64_t>(value);
}

/// Byte order if the first bytes are a version 5 header with a correct checksum.
std::optional<std::endian> order_of(const std::string& head) {
    if (head.size() < header_bytes) return std::nullopt;
    for (const auto order : {std::endian::little, std::endian::big}) {
        if (bytes::load<std::int16_t>(head.data(), order) != 5) continue;
        std::uint16_t sum = 0;
        for (std::size_t at = 0; at < header_bytes; at += 2)
            sum = static_cast<std::uint16_t>(sum + bytes::load<std::uint16_t>(head.data() + at, order));
        if (sum == 0) return order;
    }
    return std::nullopt;
}

Wave wave_of(const std::string& head, std::endian order, const bytes::Source& source) {
    Wave wave{order, 0, 0, 0, 0, 0, 0, 0};
    const auto size = [&](std::size_t at) { return size_at(head, at, order, source); };
    const auto type = bytes::load<std::int16_t>(head.data() + 80, order);
    wave.number_bytes = type == 2 ? 4 : type == 4 ? 8 : 0;
    if (wave.number_bytes == 0)
        throw FormatError(source.name, {.offset = 80},
                          fmt::format("numbers of type {}, expected real floats of 4 or 8 bytes", type));
    wave.rows = size(132);
    wave.columns = size(136);
    const auto layers = size(140);
    if (wave.rows < 2 || wave.columns < 2 || wave.columns > 64 || layers > 1)
        throw FormatError(
            source.name, {.offset = 132},
            fmt::format("a wave of {} × {} × {}, expected samples by channels", wave.rows, wave.columns, layers));
    const auto data_end = header_bytes + wave.rows * wave.columns * wave.number_bytes;
    if (data_end > source.size)
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format("the file ends here, but its numbers extend to byte {}; it is truncated", data_end));
    if (size(4) + wave_begins < data_end)
        throw FormatError(source.name, {.offset = 4}, "the announced length of the wave is shorter than its numbers");
    wave.note_at = wave_begins + size(4) + size(8);
    wave.note_bytes = size(12);
    wave.labels_at = wave.note_at + wave.note_bytes + size(16);
    for (std::size_t k = 0; k < 4; ++k) wave.labels_at += size(20 + 4 * k);
    wave.labels_at += size(36);
    wave.labels_bytes = size(40);
    return wave;
}

/// Labels of the columns: the name of the dimension, then one per column.
std::vector<std::string> labels(const Wave& wave, const bytes::Source& source) {
    if (wave.labels_bytes < (wave.columns + 1) * label_bytes) return {};
    const auto bytes = source.bytes(wave.labels_at, wave.labels_bytes);
    std::vector<std::string> names;
    for (std::uint64_t k = 1; k <= wave.columns; ++k)
        names.emplace_back(bytes.substr(k * label_bytes, label_bytes).c_str());
    return names;
}

std::optional<std::size_t> column(const std::vector<std::string>& names, std::initializer_list<const char*> wanted) {
    for (const char* name : wanted)
        for (std::size_t k = 0; k < names.size(); ++k)
            if (names[k] == name) return k;
    return std::nullopt;
}

/// "key: value" lines of the note, which end with carriage returns.
std::map<std::string, std::string> note_of(const Wave& wave, const bytes::Source& source) {
    std::map<std::string, std::string> note;
    const auto text = bytes::decoded(source.bytes(wave.note_at, wave.note_bytes), bytes::Encoding::detect);
    for (const auto line : bytes::split_lines(text)) {
        const auto colon = line.find(':');
        if (colon != std::string_view::npos)
            note.emplace(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
    }
    return note;
}

std::optional<double> positive(const std::map<std::string, std::string>& note, const char* key) {
    const auto entry = note.find(key);
    double value = 0.0;
    if (entry == note.end() || !parse_cell(entry->second, '.', value) || !(value > 0.0) || !std::isfinite(value))
        return std::nullopt;
    return value;
}

Array1D channel(const Wave& wave, std::size_t index, const bytes::Source& source) {
    const auto count = wave.rows * wave.number_bytes;
    const auto bytes = source.bytes(header_bytes + index * count, count);
    Array1D values(static_cast<Index>(wave.rows));
    for (Index i = 0; i < values.size(); ++i) {
        const char* at = bytes.data() + static_cast<std::uint64_t>(i) * wave.number_bytes;
        values[i] = wave.number_bytes == 4 ? static_cast<double>(bytes::load<float>(at, wave.order))
                                           : bytes::load<double>(at, wave.order);
    }
    return values;
}

/// Begins of the segments, and one past the last: "Indexes" in the note, otherwise the turn of the height.
std::vector<Index> bounds(const std::map<std::string, std::string>& note, const Array1D& height) {
    std::vector<Index> result{0};
    if (const auto entry = note.find("Indexes"); entry != note.end()) {
        std::vector<std::string_view> cells;
        split_cells(entry->second, ',', cells);
        for (const auto cell : cells) {
            double value = 0.0;
            if (parse_cell(cell, '.', value) && value > static_cast<double>(result.back()) &&
                value < static_cast<double>(height.size()))
                result.push_back(static_cast<Index>(value));
        }
    }
    Index turn = 0;
    if (result.size() == 1 && height.isFinite().any()) height.maxCoeff<Eigen::PropagateNumbers>(&turn);
    if (turn > 0 && turn < height.size() - 1) result.push_back(turn + 1);
    if (result.back() < height.size() - 1) result.push_back(height.size());
    result.back() = height.size();
    return result;
}

}  // namespace

bool is_igor_force(const bytes::Source& source) {
    const auto head = source.head(header_bytes);
    const auto order = order_of(head);
    if (!order) return false;
    try {
        const auto names = labels(wave_of(head, *order, source), source);
        return column(names, {"Defl", "Deflection"}) && column(names, {"ZSnsr", "ZSensor", "Raw", "Height"});
    } catch (const FormatError&) {
        return false;
    }
}

ForceCurveData read_igor_force(const bytes::Source& source) {
    const auto head = source.head(header_bytes);
    const auto wave = wave_of(head, order_of(head).value_or(std::endian::little), source);
    const auto names = labels(wave, source);
    const auto deflection = column(names, {"Defl", "Deflection"}),
               height = column(names, {"ZSnsr", "ZSensor", "Raw", "Height"});
    if (!deflection || !height)
        throw FormatError(
            source.name, {},
            fmt::format("no channels of deflection and height; the file has: {}", fmt::join(names, ", ")));
    const auto note = note_of(wave, source);
    ForceCurveData data;
    data.constants = {positive(note, "SpringConstant"), positive(note, "InvOLS")};
    // the wave contains metres computed from volts with the sensitivity in the note
    data.reading = data.constants.sensitivity ? Reading::volts : Reading::deflection;
    const auto z = channel(wave, *height, source);
    const Array1D reading = channel(wave, *deflection, source) / data.constants.sensitivity.value_or(1.0);
    const auto rate = positive(note, "NumPtsPerSec");
    const auto begin = bounds(note, z);
    for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
        const auto n = begin[k + 1] - begin[k];
        const char* name = k == 0 ? "extend" : k + 2 == begin.size() ? "retract" : "pause";
        data.segments.push_back(
            {name, z.segment(begin[k], n), reading.segment(begin[k], n), rate ? static_cast<double>(n) / *rate : 0.0});
    }
    data.metadata["height_channel"] = names[*height];
    for (const auto& [key, entry] : {std::pair{"Date", "date"}, {"MicroscopeModel", "instrument"}})
        if (const auto found = note.find(key); found != note.end()) data.metadata.emplace(entry, found->second);
    return data;
}

}  // namespace setae::tables
