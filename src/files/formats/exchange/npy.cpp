// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/npy.hpp"

#include <bit>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "npy_array.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/height_likeness.hpp"
#include "writing.hpp"

namespace setae::formats {
namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";

std::string with_header(std::string_view shape, const double* values, Index count) {
    auto dictionary = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape);
    const auto unpadded = npy_magic.size() + 4 + dictionary.size() + 1;
    dictionary.append((64 - unpadded % 64) % 64, ' ').append(1, '\n');
    std::string content(npy_magic);
    content += {'\x01', '\x00', static_cast<char>(dictionary.size() & 0xff), static_cast<char>(dictionary.size() >> 8)};
    content += dictionary;
    static_assert(std::endian::native == std::endian::little, "NPY is written in the byte order of the memory");
    content.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(double));
    return content;
}

Match detect_npy(std::string_view head, const bytes::Source&) { return is_npy(head) ? Match::yes : Match::no; }

std::vector<Channel> open_npy(const bytes::Source& source, const ReadOptions& options) {
    const auto array = npy_array(source);
    if (!array.refusal.empty()) throw FormatError(source.name, {.offset = npy_magic.size()}, array.refusal);
    if (!is_map_or_line(array))
        throw FormatError(
            source.name, {.offset = npy_magic.size()},
            fmt::format("NPY: array of {} dimensions, expected 1 or 2 with more than one value", array.shape.size()));
    auto channel = array_channel({.name = "heights", .format = "npy"}, array, FirstIndex::x_to_the_right, {}, options);
    const auto why = reason_against_single_array(array);
    return {why.empty() ? std::move(channel) : doubtful_channel(std::move(channel), why)};
}

}  // namespace

Format npy_format() {
    return {
        .identifier = "npy",
        .name = "NumPy array",
        .extensions = ".npy",
        .description =
            "versions 1 to 3, floats or integers of either byte order, C or Fortran order; size and unit must be given",
        .heights = "values in the unit given; NaN and infinities are undefined",
        .orientation = "first index x, second y downwards",
        .not_read = "records, objects, texts, complex numbers and floats of 2 or 16 bytes are refused",
        .reference = "NumPy Enhancement Proposal 1",
        .tested_on_real_files = true,
        .carries_scale = false,
        .detect = detect_npy,
        .open = open_npy,
        .write = write_measurement_as_npy};
}

void write_npy(const std::string& path, const Array2D& values) {
    bytes::write_whole_file(
        path, with_header(fmt::format("({}, {})", values.rows(), values.cols()), values.data(), values.size()));
}

void write_npy(const std::string& path, const Array1D& values) {
    bytes::write_whole_file(path, with_header(fmt::format("({},)", values.size()), values.data(), values.size()));
}

}  // namespace setae::formats
