// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/npy.hpp"

#include <charconv>
#include <map>
#include <utility>
#include <cstdint>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "bytes.hpp"
#include "channel_building.hpp"
#include "format_list.hpp"
#include "raster.hpp"
#include "setae/core/errors.hpp"
#include "writing.hpp"
#include "setae/core/text.hpp"
#include "setae/io/whole_file.hpp"

namespace setae::io {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

/// What an NPY header says.
struct NpyHeader {
    char kind = 'f';         ///< f, i or u
    std::size_t bytes = 8;   ///< of one value
    std::endian order = std::endian::little;
    bool fortran = false;
    std::vector<Index> shape;
    std::uint64_t data_offset = 0;
};

[[noreturn]] void broken(const Source& source, std::uint64_t offset, const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, "NPY: " + what);
}

/// Text behind 'key': in the header's dictionary.
std::string_view entry(std::string_view dictionary, std::string_view key, const Source& source) {
    const auto at = dictionary.find(fmt::format("'{}'", key));
    const auto colon = at == std::string_view::npos ? at : dictionary.find(':', at);
    if (colon == std::string_view::npos) broken(source, magic.size(), fmt::format("header has no '{}'", key));
    return trimmed(dictionary.substr(colon + 1));
}

void parse_type(std::string_view text, NpyHeader& header, const Source& source) {
    const auto type = text.substr(1, text.substr(1).find(text.front()));
    const bool known = type.size() == 3 && std::string_view("<>|=").find(type[0]) != std::string_view::npos &&
                       (type == "|i1" || type == "|u1" || type[1] == 'f' || type[1] == 'i' || type[1] == 'u') &&
                       std::string_view(type[1] == 'f' ? "48" : "1248").find(type[2]) != std::string_view::npos;
    if (!known) broken(source, magic.size(), fmt::format("values of type '{}', expected floats of 4 or 8 bytes or integers", type));
    header.order = type[0] == '>' ? std::endian::big : std::endian::little;
    header.kind = type[1];
    header.bytes = static_cast<std::size_t>(type[2] - '0');
}

void parse_shape(std::string_view text, NpyHeader& header, const Source& source) {
    const auto close = text.find(')');
    if (!text.starts_with('(') || close == std::string_view::npos) broken(source, magic.size(), "header's shape is no tuple");
    auto body = text.substr(1, close - 1);
    while (!trimmed(body).empty()) {
        const auto comma = body.find(',');
        const auto number = trimmed(body.substr(0, comma));
        Index extent = -1;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), extent);
        if (error != std::errc{} || end != number.data() + number.size() || extent < 0)
            broken(source, magic.size(), fmt::format("'{:.40}' in the header's shape", number));
        header.shape.push_back(extent);
        body = comma == std::string_view::npos ? std::string_view{} : body.substr(comma + 1);
    }
}

NpyHeader parse_npy_header(const Source& source) {
    const auto start = source.head(12);
    const auto version = start.size() > 6 ? static_cast<unsigned char>(start[6]) : 0u;
    if (start.size() < 12 || version < 1 || version > 3) broken(source, 6, fmt::format("version {}, expected 1, 2 or 3", version));
    const std::uint64_t length = version == 1 ? load<std::uint16_t>(start.data() + 8, std::endian::little)
                                              : load<std::uint32_t>(start.data() + 8, std::endian::little);
    NpyHeader header;
    const std::uint64_t begin = version == 1 ? 10 : 12;
    header.data_offset = begin + length;
    const auto dictionary = source.bytes(begin, length);
    const auto type = entry(dictionary, "descr", source);
    if (type.empty() || (type.front() != '\'' && type.front() != '"')) broken(source, begin, "records, expected an array of numbers");
    parse_type(type, header, source);
    header.fortran = entry(dictionary, "fortran_order", source).starts_with("True");
    parse_shape(entry(dictionary, "shape", source), header, source);
    return header;
}

/// Bytes of the data, checked to be there without overflow.
std::uint64_t data_bytes(const NpyHeader& header, const Source& source) {
    std::uint64_t count = header.bytes;
    for (const auto extent : header.shape) {
        const auto n = static_cast<std::uint64_t>(extent);
        if (n != 0 && count > source.size / n)
            broken(source, source.size, fmt::format("the header announces {} values of {} bytes, the file has {} bytes",
                                                    fmt::format("{}", header.shape.front()) + (header.shape.size() > 1 ? fmt::format(" × {}", header.shape[1]) : ""),
                                                    header.bytes, source.size));
        count *= n;
    }
    if (header.data_offset + count > source.size)
        broken(source, source.size, fmt::format("the file ends here, its data should end at byte {}; it is truncated", header.data_offset + count));
    return count;
}

Sample sample_of(const NpyHeader& header) {
    static const std::map<std::pair<char, std::size_t>, Sample> samples{
        {{'i', 1}, Sample::int8},   {{'u', 1}, Sample::uint8},  {{'i', 2}, Sample::int16},   {{'u', 2}, Sample::uint16},  {{'i', 4}, Sample::int32},
        {{'u', 4}, Sample::uint32}, {{'i', 8}, Sample::int64},  {{'u', 8}, Sample::uint64}, {{'f', 4}, Sample::float32}, {{'f', 8}, Sample::float64}};
    return samples.at({header.kind, header.bytes});
}

std::string with_header(std::string_view shape, const double* values, Index count) {
    auto dictionary = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape);
    const auto unpadded = magic.size() + 4 + dictionary.size() + 1;
    dictionary.append((64 - unpadded % 64) % 64, ' ').append(1, '\n');
    std::string content(magic);
    content += {'\x01', '\x00', static_cast<char>(dictionary.size() & 0xff), static_cast<char>(dictionary.size() >> 8)};
    content += dictionary;
    static_assert(std::endian::native == std::endian::little, "NPY is written as the memory holds it");
    content.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(double));
    return content;
}

Match detect_npy(std::string_view head, const Source&) { return head.starts_with(magic) ? Match::yes : Match::no; }

std::vector<Channel> open_npy(const Source& source, const ReadOptions& options) {
    const auto header = parse_npy_header(source);
    if (header.shape.empty() || header.shape.size() > 2)
        broken(source, magic.size(), fmt::format("array of {} dimensions, expected 1 or 2", header.shape.size()));
    (void)data_bytes(header, source);
    ChannelInfo info{.name = "heights", .format = "npy"};
    const bool line = header.shape.size() == 1;
    if (!line) info.orientation = "first index x, second y downwards, as stored";
    const Raster raster{.offset = header.data_offset, .nx = header.shape[0], .ny = line ? 1 : header.shape[1], .sample = sample_of(header), .order = header.order,
                        .columns = !line && !header.fortran};
    return {raster_channel(std::move(info), source, raster, {}, options)};
}

}  // namespace

Format npy_format() {
    return {.identifier = "npy",
            .name = "NumPy array",
            .extensions = ".npy",
            .description = "versions 1 to 3, floats or integers of either byte order, C or Fortran order; size and unit must be given",
            .heights = "values in the unit given; NaN and infinities are undefined",
            .orientation = "first index x, second y downwards",
            .reference = "NumPy Enhancement Proposal 1",
            .tested_on_real_files = true,
            .carries_scale = false,
            .detect = detect_npy,
            .open = open_npy,
            .write = write_measurement_as_npy};
}

void write_npy(const std::string& path, const Array2D& values) {
    write_whole_file(path, with_header(fmt::format("({}, {})", values.rows(), values.cols()), values.data(), values.size()));
}

void write_npy(const std::string& path, const Array1D& values) {
    write_whole_file(path, with_header(fmt::format("({},)", values.size()), values.data(), values.size()));
}

}  // namespace setae::io
