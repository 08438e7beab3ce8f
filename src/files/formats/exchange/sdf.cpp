// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "sdf_writer.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/raster.hpp"

// SDF (ISO 25178-71): "aISO-1.0" with lines "Key = value", a line "*", the heights as text, "*", a trailer, "*"; or
// "bISO-1.0" with the same header packed and binary heights, little-endian. Version 2.0 counts points in 32 bits.
// height [m] = value · Zscale.
namespace setae::formats {
namespace {

constexpr std::uint64_t longest_sdf_header = 1 << 16;
constexpr std::size_t magic_bytes = 8;

/// Content of the header.
struct SdfHeader {
    bool text = false;
    std::string manufacturer, created, modified;
    Index nx = 0, ny = 0;  ///< points of a profile, profiles
    double x_scale = 0.0, y_scale = 0.0, z_scale = 0.0, z_resolution = 0.0;
    long compression = 0, type = -1, check = 0;
    std::uint64_t data = 0;  ///< offset
    std::map<std::string, std::string> others;
};

[[noreturn]] void broken_sdf(const bytes::Source& source, std::uint64_t offset, const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, "SDF: " + what);
}

/// "040120100853" is 2010-01-04 08:53; zeros are no date.
std::string written_date(const std::string& digits) {
    if (digits.size() != 12 || digits.find_first_not_of("0123456789") != std::string::npos) return digits;
    if (digits.find_first_not_of('0') == std::string::npos) return {};
    return fmt::format("{}-{}-{} {}:{}", digits.substr(4, 4), digits.substr(2, 2), digits.substr(0, 2),
                       digits.substr(8, 2), digits.substr(10, 2));
}

// ---- header of text
// ---------------------------------------------------------------------------------------------------

/// "Key = value" or "Key value".
struct Line {
    std::string key, value;
};

Line parsed_line(std::string_view line) {
    const auto end = std::min(line.find_first_of("= \t"), line.size());
    auto value = trimmed(line.substr(end));
    if (value.starts_with('=')) value = trimmed(value.substr(1));
    return {std::string(line.substr(0, end)), std::string(value)};
}

double number(const std::string& text, const std::string& key, const bytes::Source& source, std::uint64_t offset) {
    double value = 0.0;
    if (!bytes::parse_cell(text, '.', value) || !std::isfinite(value))
        broken_sdf(source, offset, fmt::format("{} is '{:.40}', expected a number", key, text));
    return value;
}

long integer(const std::string& text, const std::string& key, const bytes::Source& source, std::uint64_t offset) {
    const double value = number(text, key, source, offset);
    if (value != std::floor(value) || std::abs(value) > 4.3e9)
        broken_sdf(source, offset, fmt::format("{} is '{:.40}', expected an integer", key, text));
    return static_cast<long>(value);
}

void take_line(SdfHeader& header, std::string_view line, const bytes::Source& source, std::uint64_t offset) {
    const auto [name, value] = parsed_line(line);
    const auto key = bytes::lowered(name);
    if (key == "manufacid") header.manufacturer = value;
    else if (key == "createdate") header.created = value;
    else if (key == "moddate") header.modified = value;
    else if (key == "numpoints") header.nx = integer(value, name, source, offset);
    else if (key == "numprofiles") header.ny = integer(value, name, source, offset);
    else if (key == "xscale") header.x_scale = number(value, name, source, offset);
    else if (key == "yscale") header.y_scale = number(value, name, source, offset);
    else if (key == "zscale") header.z_scale = number(value, name, source, offset);
    else if (key == "zresolution") header.z_resolution = number(value, name, source, offset);
    else if (key == "compression") header.compression = integer(value, name, source, offset);
    else if (key == "datatype") header.type = integer(value, name, source, offset);
    else if (key == "checktype") header.check = integer(value, name, source, offset);
    else if (!value.empty()) header.others[name] = value;
}

SdfHeader text_header(const bytes::Source& source) {
    SdfHeader header;
    header.text = true;
    const auto head = source.head(longest_sdf_header);
    for (std::size_t at = magic_bytes; at < head.size();) {
        const auto end = head.find_first_of("\r\n", at);
        if (end == std::string::npos) break;
        const auto line = trimmed(std::string_view(head).substr(at, end - at));
        if (line.starts_with('*')) {
            header.data = head.find('*', at) + 1;
            return header;
        }
        if (!line.empty() && line[0] != ';') take_line(header, line, source, at);
        at = end + 1;
    }
    broken_sdf(source, head.size(),
               fmt::format("the header does not end with a line '*' in its first {} bytes; it is truncated or damaged",
                           head.size()));
}

// ---- binary header
// ----------------------------------------------------------------------------------------------------

SdfHeader binary_header(const bytes::Source& source, bool wide) {
    SdfHeader header;
    bytes::Cursor cursor(source, "SDF", magic_bytes);
    header.manufacturer = cursor.text(10);
    header.created = cursor.text(12);
    header.modified = cursor.text(12);
    header.nx =
        wide ? static_cast<Index>(cursor.number<std::uint32_t>()) : static_cast<Index>(cursor.number<std::uint16_t>());
    header.ny =
        wide ? static_cast<Index>(cursor.number<std::uint32_t>()) : static_cast<Index>(cursor.number<std::uint16_t>());
    header.x_scale = cursor.number<double>();
    header.y_scale = cursor.number<double>();
    header.z_scale = cursor.number<double>();
    header.z_resolution = cursor.number<double>();
    header.compression = cursor.number<std::uint8_t>();
    header.type = cursor.number<std::uint8_t>();
    header.check = cursor.number<std::uint8_t>();
    header.data = cursor.position();
    return header;
}

// ---- both
// -------------------------------------------------------------------------------------------------------------

constexpr std::array sdf_samples{Sample::uint8, Sample::uint16, Sample::uint32, Sample::float32,
                                 Sample::int8,  Sample::int16,  Sample::int32,  Sample::float64};

/// The value of each binary type for an undefined height: the smallest of signed types, as in the standard; the largest
/// of unsigned types of 16 and 32 bits, as in Gwyddion. Unsigned bytes have none.
std::vector<double> undefined_values(Sample sample) {
    switch (sample) {
        case Sample::uint16: return {std::numeric_limits<std::uint16_t>::max()};
        case Sample::uint32: return {std::numeric_limits<std::uint32_t>::max()};
        case Sample::float32: return {static_cast<double>(std::numeric_limits<float>::lowest())};
        case Sample::int8: return {std::numeric_limits<std::int8_t>::min()};
        case Sample::int16: return {std::numeric_limits<std::int16_t>::min()};
        case Sample::int32: return {std::numeric_limits<std::int32_t>::min()};
        case Sample::float64: return {std::numeric_limits<double>::lowest()};
        default: return {};
    }
}

SdfHeader checked_header(SdfHeader header, const bytes::Source& source) {
    if (header.nx < 1 || header.ny < 1)
        broken_sdf(source, header.data,
                   fmt::format("{} profiles of {} points, expected at least one of each", header.ny, header.nx));
    if (header.compression != 0)
        broken_sdf(source, header.data,
                   fmt::format("compression {}, which the standard does not describe; save it uncompressed",
                               header.compression));
    if (header.type < 0 || header.type >= static_cast<long>(sdf_samples.size()))
        broken_sdf(source, header.data,
                   fmt::format("data type {}, expected 0 to {}", header.type, sdf_samples.size() - 1));
    if (header.z_scale == 0.0 || !std::isfinite(header.z_scale))
        broken_sdf(source, header.data,
                   fmt::format("Zscale is {}, expected metres per unit of height", header.z_scale));
    return header;
}

SdfHeader read_header(const bytes::Source& source) {
    const auto magic = source.bytes(0, magic_bytes);
    const auto version = magic.substr(5);
    if (version != "1.0" && version != "2.0")
        broken_sdf(source, 5, fmt::format("version '{}', expected 1.0 or 2.0", version));
    return checked_header(magic[0] == 'a' ? text_header(source) : binary_header(source, version == "2.0"), source);
}

// ---- trailer of text
// --------------------------------------------------------------------------------------------------

/// "Key = value" or "< Key > value < / Key >", as in the example of the standard.
void keep_trailer(std::string_view text, topography::Metadata& metadata) {
    for (const auto raw : bytes::split_lines(text)) {
        auto line = trimmed(raw);
        if (line.empty() || line[0] == ';') continue;
        const bool tagged = line[0] == '<';
        const auto middle = line.find(tagged ? '>' : '=');
        if (middle == std::string_view::npos) continue;
        const auto key = trimmed(line.substr(tagged ? 1 : 0, middle - (tagged ? 1 : 0)));
        auto value = line.substr(middle + 1);
        if (tagged) value = value.substr(0, value.find('<'));
        if (!key.empty() && !trimmed(value).empty()) metadata.attributes[std::string(key)] = trimmed(value);
    }
}

/// The trailer after the heights, if it is within the last bytes of the file.
void read_trailer(const bytes::Source& source, std::uint64_t data, topography::Metadata& metadata) {
    const auto from = std::max(data, source.size - std::min(source.size, longest_sdf_header));
    const auto tail = bytes::decoded(source.bytes(from, source.size - from), bytes::Encoding::detect);
    const auto begin = tail.find('*');
    if (begin == std::string::npos) return;
    const auto end = std::min(tail.find('*', begin + 1), tail.size());
    keep_trailer(std::string_view(tail).substr(begin + 1, end - begin - 1), metadata);
}

// ---- heights of text
// --------------------------------------------------------------------------------------------------

/// Words between white space up to '*' or the end, in pieces.
class Words {
public:
    Words(const bytes::Source& source, std::uint64_t offset) : source_(source), next_(offset), at_(offset) {}

    /// The next word; empty after the last.
    std::string_view word() {
        for (;;) {
            const auto begin = piece_.find_first_not_of(" \t\r\n", used_);
            const auto end = begin == std::string::npos ? std::string::npos : piece_.find_first_of(" \t\r\n*", begin);
            if (begin != std::string::npos && piece_[begin] == '*') {
                at_ += begin - used_;
                used_ = begin;
                return {};
            }
            if (end != std::string::npos || (next_ == source_.size && begin != std::string::npos)) {
                const auto stop = std::min(end, piece_.size());
                at_ += stop - used_;
                used_ = stop;
                whole_ = end != std::string::npos;
                return std::string_view(piece_).substr(begin, stop - begin);
            }
            if (next_ == source_.size) return {};
            if (piece_.size() - used_ > longest_word) broken_sdf(source_, at_, "expected numbers");
            refill();
        }
    }
    /// Whether the last word ends inside the file: otherwise it may be a part.
    [[nodiscard]] bool whole() const { return whole_; }
    [[nodiscard]] std::uint64_t position() const { return at_; }

private:
    static constexpr std::uint64_t piece_bytes = 1 << 20;
    static constexpr std::size_t longest_word = 2 * piece_bytes;

    void refill() {
        const auto count = std::min(piece_bytes, source_.size - next_);
        piece_.erase(0, used_);
        used_ = 0;
        piece_ += source_.bytes(next_, count);
        next_ += count;
    }

    const bytes::Source& source_;
    std::string piece_;
    std::size_t used_ = 0;
    std::uint64_t next_, at_;  ///< of the next piece, of the first byte not yet used
    bool whole_ = true;
};

double text_height(std::string_view word, double scale, const bytes::Source& source, std::uint64_t offset) {
    if (word == "BAD") return undefined;
    double value = 0.0;
    if (!bytes::parse_cell(word, '.', value))
        broken_sdf(source, offset, fmt::format("'{:.40}' among the heights, expected a number or BAD", word));
    return value * scale;
}

topography::Measurement read_text(const bytes::Source& source, const SdfHeader& header, const std::vector<double>& size,
                                  const topography::Metadata& metadata) {
    Words words(source, header.data);
    Array2D heights(header.nx, header.ny);
    for (Index j = 0; j < header.ny; ++j)
        for (Index i = 0; i < header.nx; ++i) {
            const auto word = words.word();
            if (word.empty() || !words.whole())
                broken_sdf(source, words.position(),
                           fmt::format("the heights end here, at point {} of {} × {}; it is truncated",
                                       j * header.nx + i + 1, header.nx, header.ny));
            heights(i, j) = text_height(word, header.z_scale, source, words.position() - word.size());
        }
    if (const auto more = words.word(); !more.empty())
        broken_sdf(source, words.position() - more.size(),
                   fmt::format("more heights than {} × {}", header.nx, header.ny));
    if (size.size() == 1)
        return checked(
            topography::LineScan{Eigen::Map<const Array1D>(heights.data(), heights.size()), size[0], false, metadata},
            source);
    return checked(topography::HeightMap{std::move(heights), {size[0], size[1]}, false, metadata}, source);
}

/// A channel of text, whose numbers are parsed on request. Each needs at least two bytes: a smaller file cannot contain
/// them.
Channel text_channel(ChannelInfo info, const bytes::Source& source, const SdfHeader& header,
                     const ReadOptions& options) {
    const auto room = (source.size - header.data + 1) / 2;
    const auto nx = static_cast<std::uint64_t>(header.nx), ny = static_cast<std::uint64_t>(header.ny);
    if (ny > room || nx > room / ny)
        broken_sdf(source, source.size,
                   fmt::format("the file ends here and is too short for {} × {} heights; it is truncated or damaged",
                               header.nx, header.ny));
    info.shape = header.ny == 1 ? std::vector<Index>{header.nx} : std::vector<Index>{header.nx, header.ny};
    info.size.resize(std::min(info.size.size(), info.shape.size()));
    (void)complete(info, options, source);
    if (info.size.empty()) return incomplete_channel(std::move(info), source);
    auto read = [source, header, size = info.size, metadata = info.metadata] {
        return read_text(source, header, size, metadata);
    };
    return {std::move(info), std::move(read)};
}

/// Olympus writes two additional numbers of 32 bits, 5 and 1, between header and heights: such files are longer than
/// stated in the header.
std::uint64_t binary_data(const bytes::Source& source, const SdfHeader& header, Sample sample) {
    const auto heights =
        static_cast<std::uint64_t>(header.nx) * static_cast<std::uint64_t>(header.ny);  // each below 2^32
    const bool longer = heights < source.size && source.size > header.data + heights * bytes_of(sample);
    if (!longer || source.size - header.data < 2 * sizeof(std::uint32_t)) return header.data;
    bytes::Cursor cursor(source, "SDF", header.data);
    const auto first = cursor.number<std::uint32_t>(), second = cursor.number<std::uint32_t>();
    return first == 5 && second == 1 ? cursor.position() : header.data;
}

std::vector<Channel> open_sdf(const bytes::Source& source, const ReadOptions& options) {
    const auto header = read_header(source);
    const auto sample = sdf_samples[static_cast<std::size_t>(header.type)];
    ChannelInfo info{.name = "height", .format = "sdf", .unit = "m"};
    info.metadata.attributes = header.others;
    info.metadata.instrument.name = header.manufacturer;
    info.metadata.acquisition_time = written_date(header.created);
    if (const auto modified = written_date(header.modified); !modified.empty())
        info.metadata.attributes["modified"] = modified;
    if (header.z_resolution > 0.0) info.metadata.attributes["z_resolution"] = fmt::format("{} m", header.z_resolution);
    if (header.check != 0) info.metadata.attributes["check_type"] = fmt::format("{}", header.check);
    if (header.ny > 1) info.orientation = "rows from the top, as stored";
    if (header.x_scale != 0.0 && (header.y_scale != 0.0 || header.ny == 1))
        info.size = {header.x_scale * static_cast<double>(header.nx), header.y_scale * static_cast<double>(header.ny)};
    if (header.text) {
        read_trailer(source, header.data, info.metadata);
        return {text_channel(std::move(info), source, header, options)};
    }
    const Raster raster{
        .offset = binary_data(source, header, sample), .nx = header.nx, .ny = header.ny, .sample = sample};
    return {raster_channel(std::move(info), source, raster,
                           {.factor = header.z_scale, .undefined = undefined_values(sample)}, options)};
}

Match detect_sdf(std::string_view head, const bytes::Source&) {
    return head.starts_with("aISO-") || head.starts_with("bISO-") ? Match::yes : Match::no;
}

}  // namespace

Format sdf_format() {
    return {
        .identifier = "sdf",
        .name = "Surface Data File",
        .extensions = ".sdf",
        .description =
            "text (aISO-1.0) or binary (bISO-1.0), all eight data types, with the 32-bit counts of version 2.0 and Olympus's longer header; the trailer of text is kept as attributes",
        .heights =
            "value times Zscale, in metres; BAD in text, the least value of signed types and floats and the greatest of unsigned ones of 16 and 32 bits are undefined",
        .orientation = "rows from the top, as Gwyddion takes them; the standard names no direction",
        .not_read = "compressed data, which the standard does not define, are refused; check sums are not verified",
        .reference = "ISO 25178-71:2012; Gwyddion's sdfile module for undefined values and Olympus's header",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_sdf,
        .open = open_sdf,
        .write = write_sdf};
}

}  // namespace setae::formats
