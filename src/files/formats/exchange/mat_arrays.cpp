// SPDX-License-Identifier: GPL-3.0-or-later
#include "mat_arrays.hpp"

#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/cursor.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "storage/on_demand.hpp"

namespace setae::formats {
namespace {

constexpr const char* mat_name = "MAT";
constexpr std::uint64_t level5_header = 128, tag_bytes = 8;
constexpr std::uint64_t max_mat_values = std::uint64_t{1} << 40;

/// Types of elements of level 5.
enum Element : std::uint32_t {
    int8_element = 1,
    int32_element = 5,
    uint32_element = 6,
    matrix_element = 14,
    compressed_element = 15,
    utf8_element = 16
};

std::optional<Sample> sample_of(std::uint32_t element) {
    switch (element) {
        case 1: return Sample::int8;
        case 2: return Sample::uint8;
        case 3: return Sample::int16;
        case 4: return Sample::uint16;
        case 5: return Sample::int32;
        case 6: return Sample::uint32;
        case 7: return Sample::float32;
        case 9: return Sample::float64;
        case 12: return Sample::int64;
        case 13: return Sample::uint64;
        default: return std::nullopt;
    }
}

bool is_name(std::string_view name) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) &&
           std::all_of(name.begin(), name.end(), is_part);
}

/// The number of values of a shape; empty if it is absurd.
std::optional<std::uint64_t> values_in(const std::vector<Index>& shape) {
    std::uint64_t values = 1;
    for (const auto extent : shape) {
        if (extent < 0 || (extent > 0 && values > max_mat_values / static_cast<std::uint64_t>(extent)))
            return std::nullopt;
        values *= static_cast<std::uint64_t>(extent);
    }
    return values;
}

// ---- level 5 --------------------------------------------------------------------------------------------------------

/// Type and length of an element; small ones contain up to 4 bytes after their type.
struct MatTag {
    std::uint32_t type = 0;
    std::uint64_t bytes = 0;
    bool small = false;

    [[nodiscard]] std::uint64_t padded() const { return small ? 4 : (bytes + 7) / 8 * 8; }
};

MatTag read_tag(bytes::Cursor& cursor) {
    const auto first = cursor.number<std::uint32_t>();
    if (first >> 16) {
        if (first >> 16 > 4)
            cursor.fail(
                fmt::format("a small element of {} bytes, expected at most 4; the file is damaged", first >> 16));
        return {first & 0xffff, first >> 16, true};
    }
    return {first, cursor.number<std::uint32_t>(), false};
}

/// A part of a matrix before its values.
std::string part(bytes::Cursor& cursor, std::uint32_t type, const char* what, std::uint64_t most) {
    const auto tag = read_tag(cursor);
    if (tag.type != type && !(type == int8_element && tag.type == utf8_element))
        cursor.fail(fmt::format("{} of type {}, expected {}; the file is damaged", what, tag.type, type));
    if (tag.bytes > most)
        cursor.fail(fmt::format("{} of {} bytes, expected at most {}; the file is damaged", what, tag.bytes, most));
    auto bytes = cursor.bytes(tag.padded());
    bytes.resize(tag.bytes);
    return bytes;
}

/// A matrix from its tag on, if it contains numbers. `cursor` needs only the header; values are checked on reading.
std::optional<MatVariable> matrix(bytes::Cursor& cursor, std::endian order) {
    constexpr std::uint32_t first_numeric = 6, first_integer = 8, last_numeric = 15, complex_flag = 0x0800,
                            logical_flag = 0x0200;
    const auto whole = read_tag(cursor);
    if (whole.type != matrix_element || whole.bytes == 0) return std::nullopt;
    const auto end = cursor.position() + whole.bytes;
    const auto flags_part = part(cursor, uint32_element, "flags", 8);
    if (flags_part.size() < 8) cursor.fail("flags of less than 8 bytes; the file is damaged");
    const auto flags = bytes::load<std::uint32_t>(flags_part.data(), order);
    const auto kind = flags & 0xff;
    if (kind < first_numeric || kind > last_numeric || (flags & logical_flag)) return std::nullopt;
    MatVariable variable;
    variable.complex = (flags & complex_flag) != 0;
    variable.integers = kind >= first_integer;
    auto& array = variable.array;
    const auto extents = part(cursor, int32_element, "dimensions", 4 * 64);
    for (std::size_t at = 0; at + 4 <= extents.size(); at += 4)
        array.shape.push_back(bytes::load<std::int32_t>(extents.data() + at, order));
    array.name = part(cursor, int8_element, "a name", 4096);
    const auto values = read_tag(cursor);
    const auto sample = sample_of(values.type);
    const auto count = values_in(array.shape);
    if (!count || !sample || *count * bytes_of(*sample) != values.bytes ||
        values.bytes > end - std::min(end, cursor.position()))
        cursor.fail(fmt::format("matrix '{:.64}' of {} dimensions has {} bytes of type {}; the file is damaged",
                                array.name, array.shape.size(), values.bytes, values.type));
    array.sample = *sample;
    array.order = order;
    array.first_fast = true;
    array.offset = cursor.position();
    return variable;
}

/// The values of a compressed element, expanded while they are referenced.
void place_compressed(MatVariable& variable, const bytes::Source& source, std::uint64_t offset, std::uint64_t packed,
                      std::uint64_t expanded) {
    const auto content = std::make_shared<OnDemand<const std::string>>([source, offset, packed, expanded] {
        auto bytes = bytes::inflated(source.bytes(offset, packed), source, offset, mat_name);
        if (bytes.size() < expanded)
            throw FormatError(source.name, {.offset = offset + packed},
                              fmt::format("MAT: {} bytes expand to {}, expected {}; the file is damaged", packed,
                                          bytes.size(), expanded));
        return std::make_shared<const std::string>(std::move(bytes));
    });
    variable.array.data = {
        source.name,
        expanded,
        {},
        [content, name = source.name, expanded](std::uint64_t from, std::uint64_t count, char* target) {
            if (from > expanded || count > expanded - from)
                throw FormatError(name, {}, "MAT: values beyond the end of their element");
            const auto kept = content->hold();
            std::copy_n(kept->data() + from, count, target);
        }};
    variable.array.hold = [content] { return content->hold(); };
}

/// The matrix in a compressed element: only the part needed for its header is expanded.
std::optional<MatVariable> compressed_matrix(const bytes::Source& source, std::uint64_t offset, std::uint64_t packed,
                                             std::endian order) {
    constexpr std::uint64_t header_bytes = 1 << 14;
    const auto head =
        bytes::inflated(source.bytes(offset, std::min(packed, header_bytes)), source, offset, mat_name, tag_bytes);
    if (head.size() < tag_bytes)
        throw FormatError(source.name, {.offset = offset},
                          fmt::format("MAT: a compressed element of {} bytes; the file is damaged", head.size()));
    const std::uint64_t expanded = tag_bytes + bytes::load<std::uint32_t>(head.data() + 4, order);
    const auto seen = bytes::memory_source(source.name, head);
    bytes::Cursor cursor(seen, "MAT: compressed element", 0, order);
    auto variable = matrix(cursor, order);
    if (!variable) return variable;
    variable->array.data = source;
    if (expanded > bytes::max_expanded(packed))
        variable->array.refusal = fmt::format(
            "MAT: matrix '{:.64}' of {} compressed bytes would become {}, more than {}; if you trust the "
            "file, save it uncompressed (-v6)",
            variable->array.name, packed, expanded, bytes::max_expanded(packed));
    else place_compressed(*variable, source, offset, packed, expanded);
    return variable;
}

// ---- level 4 --------------------------------------------------------------------------------------------------------

/// The header of a matrix: type "MOPT" as decimal digits (byte order, 0, precision, kind), rows, columns, whether
/// complex, length of the name with its NUL.
struct Level4 {
    static constexpr std::uint64_t bytes = 20;
    std::endian order = std::endian::little;
    Sample sample = Sample::float64;
    std::uint32_t kind = 0;
    std::int32_t rows = 0, columns = 0;
    bool complex = false;
    std::uint32_t name_bytes = 0;

    [[nodiscard]] bool is_numeric() const { return kind == 0; }
    [[nodiscard]] std::uint64_t values() const {
        return static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns);
    }
};

std::optional<Level4> level4_header(std::string_view head, std::endian order) {
    constexpr Sample precisions[] = {Sample::float64, Sample::float32, Sample::int32,
                                     Sample::int16,   Sample::uint16,  Sample::uint8};
    if (head.size() < Level4::bytes) return std::nullopt;
    const auto number = [&](std::size_t k) { return bytes::load<std::uint32_t>(head.data() + 4 * k, order); };
    const auto type = number(0);
    const auto machine = type / 1000, precision = type / 10 % 10, kind = type % 10;
    const bool known_type = machine == (order == std::endian::little ? 0u : 1u) && type / 100 % 10 == 0 &&
                            precision < std::size(precisions) && kind < 3;
    const bool fits = known_type && number(3) < 2 && number(4) > 1 && number(4) <= 64;
    const auto rows = bytes::load<std::int32_t>(head.data() + 4, order),
               columns = bytes::load<std::int32_t>(head.data() + 8, order);
    const Level4 header{order, precisions[fits ? precision : 0], kind, rows, columns, number(3) == 1, number(4)};
    if (!fits || header.rows < 0 || header.columns < 0 || header.values() > max_mat_values) return std::nullopt;
    return header;
}

/// The name after a header, if it is one.
std::optional<std::string> level4_name(std::string_view bytes) {
    if (bytes.empty() || bytes.back() != '\0') return std::nullopt;
    const std::string name(bytes.substr(0, bytes.find('\0')));
    return is_name(name) ? std::optional(name) : std::nullopt;
}

std::optional<Level4> first_level4(std::string_view head) {
    for (const auto order : {std::endian::little, std::endian::big})
        if (auto header = level4_header(head, order)) return header;
    return std::nullopt;
}

}  // namespace

bool is_mat5(std::string_view head) {
    return head.size() >= level5_header &&
           (head.substr(124, 4) == std::string_view("\x00\x01IM", 4) ||
            head.substr(124, 4) == std::string_view("\x01\x00MI", 4)) &&
           std::all_of(head.begin(), head.begin() + 4, [](char c) { return c != '\0'; });
}

bool can_be_mat4(std::string_view head) {
    const auto header = first_level4(head);
    return header && head.size() >= Level4::bytes + header->name_bytes &&
           level4_name(head.substr(Level4::bytes, header->name_bytes));
}

std::vector<MatVariable> mat5_variables(const bytes::Source& source) {
    const auto order = source.bytes(126, 2) == "IM" ? std::endian::little : std::endian::big;
    bytes::Cursor cursor(source, mat_name, level5_header, order);
    std::vector<MatVariable> variables;
    while (!cursor.at_end()) {
        const auto start = cursor.position();
        const auto tag = read_tag(cursor);
        const auto content = cursor.position();
        if (tag.type == compressed_element) {
            cursor.skip(tag.bytes);
            if (auto variable = compressed_matrix(source, content, tag.bytes, order))
                variables.push_back(std::move(*variable));
            continue;
        }
        cursor.skip(std::min(tag.padded(), std::max(cursor.remaining(), tag.bytes)));  // the padding of the last
                                                                                       // element may be missing
        if (tag.type != matrix_element) continue;
        const auto next = cursor.position();
        cursor.seek(start);
        if (auto variable = matrix(cursor, order)) {
            variable->array.data = source;
            variables.push_back(std::move(*variable));
        }
        cursor.seek(next);
    }
    return variables;
}

std::vector<MatVariable> mat4_variables(const bytes::Source& source) {
    bytes::Cursor cursor(source, mat_name);
    std::vector<MatVariable> variables;
    while (!cursor.at_end()) {
        const auto header = first_level4(cursor.bytes(Level4::bytes));
        if (!header) cursor.fail("no header of a matrix; the file is damaged");
        const auto name = level4_name(cursor.bytes(header->name_bytes));
        if (!name) cursor.fail("a name that MATLAB does not allow; the file is damaged");
        MatVariable variable{
            {.name = *name, .shape = {header->rows, header->columns}, .data = source, .offset = cursor.position()},
            header->complex};
        variable.array.sample = header->sample;
        variable.array.order = header->order;
        variable.array.first_fast = true;
        cursor.skip(header->values() * bytes_of(header->sample) * (header->complex ? 2 : 1));
        if (header->is_numeric()) variables.push_back(std::move(variable));
    }
    return variables;
}

}  // namespace setae::formats
