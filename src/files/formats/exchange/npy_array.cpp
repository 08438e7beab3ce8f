// SPDX-License-Identifier: GPL-3.0-or-later
#include "npy_array.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/cursor.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::formats {
namespace {

constexpr std::string_view npy_array_magic = "\x93NUMPY";
constexpr std::uint64_t longest_npy_header = 1 << 20;
constexpr std::size_t max_dimensions_of_npy = 64;

[[noreturn]] void broken_npy(const bytes::Source& source, std::uint64_t offset, const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, "NPY: " + what);
}

/// Text after 'key': in the dictionary of the header.
std::string_view entry(std::string_view dictionary, std::string_view key, const bytes::Source& source) {
    const auto at = dictionary.find(fmt::format("'{}'", key));
    const auto colon = at == std::string_view::npos ? at : dictionary.find(':', at);
    if (colon == std::string_view::npos)
        broken_npy(source, npy_array_magic.size(), fmt::format("header has no '{}'", key));
    return trimmed(dictionary.substr(colon + 1));
}

std::optional<Sample> sample_of(std::string_view kind_and_bytes) {
    static const std::map<std::string_view, Sample> samples{
        {"i1", Sample::int8},    {"u1", Sample::uint8},  {"i2", Sample::int16}, {"u2", Sample::uint16},
        {"i4", Sample::int32},   {"u4", Sample::uint32}, {"i8", Sample::int64}, {"u8", Sample::uint64},
        {"f4", Sample::float32}, {"f8", Sample::float64}};
    const auto found = samples.find(kind_and_bytes);
    return found == samples.end() ? std::nullopt : std::optional(found->second);
}

void parse_type(std::string_view text, StoredArray& array) {
    const bool quoted = text.starts_with('\'') || text.starts_with('"');
    const auto type = quoted ? text.substr(1, text.substr(1).find(text.front())) : std::string_view{};
    const auto sample = type.size() == 3 && std::string_view("<>|=").find(type[0]) != std::string_view::npos
                            ? sample_of(type.substr(1))
                            : std::nullopt;
    if (!quoted) array.refusal = "NPY: records, expected an array of numbers; save each field as a separate array";
    else if (!sample)
        array.refusal = fmt::format(
            "NPY: values of type '{:.40}', expected floats of 4 or 8 bytes or integers; convert them with astype",
            type);
    else array.sample = *sample;
    array.order = type.starts_with('>') ? std::endian::big : std::endian::little;
}

void parse_shape(std::string_view text, StoredArray& array, const bytes::Source& source) {
    const auto close = text.find(')');
    if (!text.starts_with('(') || close == std::string_view::npos)
        broken_npy(source, npy_array_magic.size(), "the shape in the header is not a tuple");
    auto body = text.substr(1, close - 1);
    while (!trimmed(body).empty()) {
        const auto comma = body.find(',');
        const auto number = trimmed(body.substr(0, comma));
        const auto extent = spelled<Index>(number);
        if (!extent || *extent < 0 || array.shape.size() == max_dimensions_of_npy)
            broken_npy(source, npy_array_magic.size(), fmt::format("'{:.40}' in the shape of the header", number));
        array.shape.push_back(*extent);
        body = comma == std::string_view::npos ? std::string_view{} : body.substr(comma + 1);
    }
}

/// Refuses a header with more values than the file.
void require_values(const StoredArray& array, const bytes::Source& source) {
    std::uint64_t count = bytes_of(array.sample);
    for (const auto extent : array.shape) {
        const auto n = static_cast<std::uint64_t>(extent);
        if (n != 0 && count > source.size / n)
            broken_npy(
                source, source.size,
                fmt::format("the header announces {} values of {} bytes, but the file has {} bytes; it is truncated",
                            fmt::join(array.shape, " × "), bytes_of(array.sample), source.size));
        count *= n;
    }
    if (array.offset + count > source.size)
        broken_npy(source, source.size,
                   fmt::format("the file ends here, expected the end of its data at byte {}; it is truncated",
                               array.offset + count));
}

}  // namespace

bool is_npy(std::string_view head) { return head.starts_with(npy_array_magic); }

StoredArray npy_array(const bytes::Source& source) {
    bytes::Cursor cursor(source, "NPY", npy_array_magic.size());
    const unsigned version = cursor.number<std::uint8_t>();
    if (version < 1 || version > 3) cursor.fail(fmt::format("version {}, expected 1, 2 or 3", version));
    cursor.skip(1);
    const std::uint64_t length = version == 1 ? cursor.number<std::uint16_t>() : cursor.number<std::uint32_t>();
    if (length > longest_npy_header)
        cursor.fail(fmt::format("a header of {} bytes, expected at most {}", length, longest_npy_header));
    const auto dictionary = cursor.bytes(length);
    StoredArray array;
    array.data = source;
    array.offset = cursor.position();
    parse_type(entry(dictionary, "descr", source), array);
    array.first_fast = entry(dictionary, "fortran_order", source).starts_with("True");
    parse_shape(entry(dictionary, "shape", source), array, source);
    if (array.refusal.empty()) require_values(array, source);
    return array;
}

}  // namespace setae::formats
