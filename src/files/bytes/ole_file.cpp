// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/ole_file.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/cursor.hpp"
#include "setae/bytes/pieces.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

constexpr std::string_view ole_signature = "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";
constexpr std::uint32_t last_sector = 0xfffffffa, end_of_chain = 0xfffffffe;
constexpr std::size_t sectors_in_header = 109;
constexpr std::uint64_t entry_bytes = 128, name_bytes = 64;
enum EntryType : std::uint8_t { stream_entry = 2, root_entry = 5 };

std::uint64_t parts(std::uint64_t size, std::uint64_t part) { return size / part + (size % part != 0); }

}  // namespace

bool is_ole(std::string_view head) { return head.starts_with(ole_signature); }

void OleFile::fail(std::uint64_t offset, const std::string& what) const {
    throw FormatError(source_.name, {.offset = std::min(offset, source_.size)},
                      fmt::format("{}: compound file: {}", format_, what));
}

OleFile::OleFile(const Source& source, std::string format) : source_(source), format_(std::move(format)) {
    Cursor header(source, format_);
    if (header.bytes(ole_signature.size()) != ole_signature) fail(0, "the file does not begin like a compound file");
    const auto shift = header.number_at<std::uint16_t>(30), small_shift = header.number_at<std::uint16_t>(32);
    if ((shift != 9 && shift != 12) || small_shift != 6)
        fail(30, fmt::format("sectors of 2^{} and 2^{} bytes, expected 2^9 or 2^12, and 2^6", shift, small_shift));
    sector_bytes_ = std::uint64_t{1} << shift;
    min_large_ = header.number_at<std::uint32_t>(56);
    sectors_ = parts(source.size - std::min(source.size, sector_bytes_), sector_bytes_);
    read_table();
    read_directory(header.number_at<std::uint32_t>(48), header.number_at<std::uint32_t>(60));
}

/// The header lists the sectors of the table; the rest is listed in a chain of sectors, each ending with the number of
/// the next.
void OleFile::read_table() {
    Cursor cursor(source_, format_, 44);
    const auto count = cursor.number<std::uint32_t>();
    if (count > sectors_)
        fail(source_.size,
             fmt::format("the file ends here, but its table has {} sectors; it is truncated or damaged", count));
    std::vector<std::uint32_t> sectors;
    cursor.seek(76);
    for (std::size_t i = 0; i < sectors_in_header && sectors.size() < count; ++i)
        sectors.push_back(cursor.number<std::uint32_t>());
    auto next = cursor.number_at<std::uint32_t>(68);
    for (std::uint64_t steps = 0; sectors.size() < count; ++steps) {
        if (next > last_sector || steps > sectors_)
            fail(68, "the list of the sectors of the table ends early or forms a loop");
        cursor.seek(offset_of(next));
        for (std::uint64_t i = 0; i + 1 < sector_bytes_ / sizeof(next); ++i) {
            const auto sector = cursor.number<std::uint32_t>();
            if (sectors.size() < count) sectors.push_back(sector);
        }
        next = cursor.number<std::uint32_t>();
    }
    table_ = numbers(sectors);
}

std::vector<std::uint32_t> OleFile::numbers(const std::vector<std::uint32_t>& sectors) const {
    std::vector<std::uint32_t> values;
    values.reserve(sectors.size() * sector_bytes_ / sizeof(std::uint32_t));
    Cursor cursor(source_, format_);
    for (const auto sector : sectors) {
        cursor.seek(offset_of(sector));
        for (std::uint64_t i = 0; i < sector_bytes_ / sizeof(std::uint32_t); ++i)
            values.push_back(cursor.number<std::uint32_t>());
    }
    return values;
}

std::vector<std::uint32_t> OleFile::chain(const std::vector<std::uint32_t>& table, std::uint32_t first,
                                          std::uint64_t count) const {
    std::vector<std::uint32_t> sectors;
    for (auto sector = first; count == 0 ? sector != end_of_chain : sectors.size() < count; sector = table[sector]) {
        if (sector >= table.size() || sectors.size() > table.size())
            fail(source_.size,
                 fmt::format("after {} sectors a chain leads to sector {}, but the table has {}; the file is damaged",
                             sectors.size(), sector, table.size()));
        sectors.push_back(sector);
    }
    return sectors;
}

void OleFile::read_directory(std::uint32_t first, std::uint32_t first_of_small_table) {
    Cursor cursor(source_, format_);
    std::uint64_t total = 0;
    for (const auto sector : chain(table_, first, 0))
        for (std::uint64_t entry = 0; entry < sector_bytes_; entry += entry_bytes) {
            cursor.seek(offset_of(sector) + entry);
            auto name = cursor.bytes(name_bytes);
            name.resize(
                std::min<std::size_t>(name.size(), std::max<std::size_t>(cursor.number<std::uint16_t>(), 2) - 2));
            const auto type = cursor.number<std::uint8_t>();
            Stream stream{decoded(std::move(name), Encoding::utf16),
                          cursor.number_at<std::uint32_t>(offset_of(sector) + entry + 116),
                          cursor.number_at<std::uint64_t>(offset_of(sector) + entry + 120)};
            if (sector_bytes_ == 512) stream.size &= 0xffffffff;  // older writers left other data in the upper half
            if (type == root_entry && small_stream_.empty() && stream.size > 0) {
                if (stream.size > source_.size)
                    fail(source_.size, "the file ends before its small streams; it is truncated or damaged");
                small_stream_ = chain(table_, stream.first, parts(stream.size, sector_bytes_));
            }
            if (type != stream_entry) continue;
            if (stream.size > source_.size - total)
                fail(source_.size,
                     fmt::format("the file ends here, but stream '{}' has {} bytes; it is truncated or damaged",
                                 stream.name, stream.size));
            total += stream.size;
            streams_.push_back(std::move(stream));
        }
    if (first_of_small_table <= last_sector) small_table_ = numbers(chain(table_, first_of_small_table, 0));
}

std::vector<std::string> OleFile::names() const {
    std::vector<std::string> names;
    for (const auto& stream : streams_) names.push_back(stream.name);
    return names;
}

bool OleFile::has(const std::string& name) const {
    return std::any_of(streams_.begin(), streams_.end(), [&](const Stream& stream) { return stream.name == name; });
}

Source OleFile::stream(const std::string& name) const {
    const auto found =
        std::find_if(streams_.begin(), streams_.end(), [&](const Stream& stream) { return stream.name == name; });
    if (found == streams_.end())
        fail(0, fmt::format("no stream '{}'; the file contains: {}", name, fmt::join(names(), ", ")));
    const bool small = found->size < min_large_;
    const auto part = small ? small_sector_bytes_ : sector_bytes_;
    std::vector<Piece> pieces;
    if (found->size > 0) {
        auto left = found->size;
        for (const auto sector : chain(small ? small_table_ : table_, found->first, parts(found->size, part))) {
            pieces.push_back({small ? small_offset_of(sector) : offset_of(sector), std::min(part, left)});
            left -= pieces.back().size;
        }
    }
    return joined(source_, fmt::format("{}: {}", source_.name, name), pieces);
}

std::uint64_t OleFile::small_offset_of(std::uint32_t sector) const {
    const auto place = std::uint64_t{sector} * small_sector_bytes_;
    if (place / sector_bytes_ >= small_stream_.size())
        fail(source_.size, fmt::format("small sector {} lies beyond the small streams; the file is damaged", sector));
    return offset_of(small_stream_[place / sector_bytes_]) + place % sector_bytes_;
}

}  // namespace setae::bytes
