// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiff_stack.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "micrograph_building.hpp"
#include "raw_pixels.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::imaging {
namespace {

namespace tag {
constexpr int width = 256, height = 257, bits = 258, compression = 259, photometric = 262, description = 270,
              strip_offsets = 273, samples = 277, rows_a_strip = 278, strip_bytes = 279, x_resolution = 282,
              y_resolution = 283, planar = 284, resolution_unit = 296, tile_width = 322, tile_height = 323,
              tile_offsets = 324, tile_bytes = 325, sample_format = 339;
}

constexpr std::uint64_t most_entries = 4096;  // of a directory; real ones have some twenty
constexpr std::size_t most_pages = 1'000'000;
constexpr std::uint64_t longest_side = 1U << 30;
constexpr std::uint64_t most_tile_pixels = 1U << 20;  // the decoder takes memory for a whole tile

std::uint64_t bytes_of_type(int type) {
    constexpr std::array<std::uint64_t, 19> bytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    return type > 0 && type < 19 ? bytes[static_cast<std::size_t>(type)] : 0;
}

std::optional<double> parsed(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !(value > 0) || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<SampleType> sample_type(std::uint64_t bits, std::uint64_t format) {
    switch (10 * bits + format) {
        case 81: return SampleType::uint8;
        case 82: return SampleType::int8;
        case 161: return SampleType::uint16;
        case 162: return SampleType::int16;
        case 163: return SampleType::float16;
        case 321: return SampleType::uint32;
        case 322: return SampleType::int32;
        case 323: return SampleType::float32;
        case 641: return SampleType::uint64;
        case 642: return SampleType::int64;
        case 643: return SampleType::float64;
        default: return std::nullopt;
    }
}

/// What libtiff may take at once: a picture, the compressed bytes of it, and a little for itself.
std::uint64_t memory_for(const bytes::TiffPieces& pieces, std::uint64_t file_bytes) {
    return 4 * pieces.nx * pieces.ny + pieces.bytes() + file_bytes + (std::uint64_t{1} << 26);
}

}  // namespace

TiffStack::TiffStack(RandomAccess file) : file_(std::move(file)) {
    read_directories();
    if (pages_.empty())
        throw FormatError(file_.path(), {.offset = 0}, "a TIFF without a page; the file may be truncated");
    add_pages_without_directory();
}

void TiffStack::read_directories() {
    const auto head = file_.read(0, 16);
    if (head.size() < 8) return;
    big_endian_ = head[0] == 'M';
    const auto at = [&](std::string_view bytes, std::size_t offset, std::size_t count) {
        return number_in(bytes, offset, count, big_endian_);
    };
    big_tiff_ = at(head, 2, 2) == 43;
    if (big_tiff_ && head.size() < 16) return;
    const std::size_t word = big_tiff_ ? 8 : 4, counter = big_tiff_ ? 8 : 2, length = big_tiff_ ? 20 : 12;
    auto offset = at(head, big_tiff_ ? 8 : 4, word);
    std::set<std::uint64_t> seen;
    std::uint64_t directories_bytes = 0,
                  values_bytes = 0;  // each part of a sound file serves once: what overlaps could grow without end
    while (offset != 0 && pages_.size() < most_pages) {
        auto& page = pages_.emplace_back();
        page.directory = offset;
        const auto damaged = [&](std::string_view what) {
            page.fault = fmt::format("its directory at byte {} {}", offset, what);
        };
        if (!seen.insert(offset).second) return pages_.pop_back();  // a ring of pages
        const auto count_bytes = file_.read(offset, counter);
        if (count_bytes.size() < counter) return damaged("lies beyond the end of the file: truncated");
        const auto count = at(count_bytes, 0, counter);
        if (count == 0 || count > most_entries) return damaged(fmt::format("has {} entries: damaged", count));
        directories_bytes += counter + count * length + word;
        const auto bytes = file_.read(offset + counter, count * length + word);
        if (bytes.size() < count * length + word) return damaged("is cut: truncated");
        if (directories_bytes > file_.size()) return damaged("overlaps others: damaged");
        for (std::size_t i = 0; i < count; ++i) {
            const auto entry_at = i * length;
            TiffEntry entry{static_cast<int>(at(bytes, entry_at + 2, 2)), at(bytes, entry_at + 4, word), {}};
            const auto unit = bytes_of_type(entry.type);
            if (unit == 0) continue;
            const auto number = static_cast<int>(at(bytes, entry_at, 2));
            const bool readable = entry.count <= file_.size();
            const auto size = readable ? unit * entry.count : 0;
            if (size > word) values_bytes += size;
            if (values_bytes > file_.size()) return damaged("shares values with others: damaged");
            if (readable)
                entry.value = size <= word ? bytes.substr(entry_at + 4 + word, size)
                                           : file_.read(at(bytes, entry_at + 4 + word, word), size);
            if (readable && entry.value.size() == size) page.entries.emplace(number, std::move(entry));
            else page.lost = fmt::format("the value of its tag {} lies beyond the end of the file: truncated", number);
        }
        offset = at(bytes, count * length, word);
    }
}

void TiffStack::add_pages_without_directory() {
    const auto images = description("images");
    const auto count = images ? parsed(*images) : std::nullopt;
    if (!count || *count <= static_cast<double>(pages_.size()) || *count > static_cast<double>(most_pages)) return;
    const auto first = pages_.front();
    const auto start = number(first, tag::strip_offsets);
    const auto size = size_of(0);
    const auto page_bytes = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                            number(first, tag::samples).value_or(1) * number(first, tag::bits).value_or(1) / 8;
    const bool contiguous = pages_.size() == 1 && start && number(first, tag::compression).value_or(1) == 1;
    while (static_cast<double>(pages_.size()) < *count) {
        const auto offset = start.value_or(0) + pages_.size() * page_bytes;
        TiffPage page;
        if (contiguous && page_bytes > 0 && offset < file_.size()) page.entries = first.entries, page.offset = offset;
        else page.fault = fmt::format("ImageJ announces {} images, the file holds fewer: truncated", *images);
        pages_.push_back(std::move(page));
    }
    if (contiguous) pages_.front().offset = start;
}

std::optional<std::uint64_t> TiffStack::number(const TiffPage& page, int tag, std::uint64_t index) const {
    const auto found = page.entries.find(tag);
    if (found == page.entries.end() || index >= found->second.count) return std::nullopt;
    const auto size = bytes_of_type(found->second.type);
    if (found->second.type == 5 || found->second.type > 16 || size == 0) return std::nullopt;
    return number_in(found->second.value, index * size, size, big_endian_);
}

std::optional<double> TiffStack::real(const TiffPage& page, int tag) const {
    const auto found = page.entries.find(tag);
    if (found == page.entries.end() || found->second.count < 1) return std::nullopt;
    const auto& [type, count, value] = found->second;
    std::optional<double> number;
    if (type == 5) number = ratio(page, tag);
    else if (type == 11)
        number =
            static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(number_in(value, 0, 4, big_endian_))));
    else if (type == 12) number = std::bit_cast<double>(number_in(value, 0, 8, big_endian_));
    else if (type == 3 || type == 4 || type == 16)
        number = static_cast<double>(number_in(value, 0, bytes_of_type(type), big_endian_));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string TiffStack::text(const TiffPage& page, int tag) const {
    const auto found = page.entries.find(tag);
    return found == page.entries.end() ? std::string() : text_of(found->second.value);
}

std::optional<double> TiffStack::ratio(const TiffPage& page, int tag) const {
    const auto found = page.entries.find(tag);
    if (found == page.entries.end() || found->second.type != 5 || found->second.count < 1) return std::nullopt;
    const auto above = number_in(found->second.value, 0, 4, big_endian_),
               below = number_in(found->second.value, 4, 4, big_endian_);
    if (above == 0 || below == 0) return std::nullopt;
    return static_cast<double>(above) / static_cast<double>(below);
}

PictureSize TiffStack::size_of(std::size_t page) const {
    const auto width = number(pages_[page], tag::width).value_or(0),
               height = number(pages_[page], tag::height).value_or(0);
    if (width > longest_side || height > longest_side) return {};
    return {static_cast<long>(width), static_cast<long>(height)};
}

std::optional<std::string> TiffStack::description(const std::string& key) const {
    const auto found = pages_.front().entries.find(tag::description);
    if (found == pages_.front().entries.end() || !found->second.value.starts_with("ImageJ=")) return std::nullopt;
    const std::string text = "\n" + found->second.value;
    const auto at = text.find("\n" + key + "=");
    if (at == std::string::npos) return std::nullopt;
    const auto begin = at + key.size() + 2;
    return std::string(
        trimmed(std::string_view(text).substr(begin, text.find_first_of(std::string_view("\n\0", 2), begin) - begin)));
}

std::optional<double> TiffStack::pixel_size() const {
    const auto& page = pages_.front();
    const auto x = ratio(page, tag::x_resolution), y = ratio(page, tag::y_resolution);
    if (!x) return std::nullopt;
    const auto stated = description("unit");
    const auto tag_unit = number(page, tag::resolution_unit).value_or(2);
    std::optional<double> unit = stated          ? metres_of(text_of(*stated))
                                 : tag_unit == 2 ? std::optional(0.0254)
                                 : tag_unit == 3 ? std::optional(0.01)
                                                 : std::nullopt;
    if (!unit) return std::nullopt;
    const double size = *unit / *x;
    if (!stated && size > coarsest_pixel) return std::nullopt;
    if (y && std::abs(*y / *x - 1.0) > 1e-3)
        throw InvalidArgument(fmt::format(
            "{}: pixels are {:.6g} m wide and {:.6g} m high; a contact radius needs square pixels, resample the frames",
            file_.path(), size, *unit / *y));
    return size;
}

std::optional<double> TiffStack::frame_rate() const {
    if (const auto rate = description("fps"))
        if (const auto value = parsed(*rate)) return value;
    if (const auto interval = description("finterval"))
        if (const auto value = parsed(*interval)) return 1.0 / *value;
    return std::nullopt;
}

std::vector<TiffStack::Part> TiffStack::parts(const TiffPage& page, std::string& fault) const {
    std::vector<Part> parts;
    if (page.offset) {
        const auto size = size_of(0);
        parts.push_back(
            {*page.offset, static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                               number(page, tag::samples).value_or(1) * number(page, tag::bits).value_or(1) / 8});
    } else {
        const bool tiled = page.entries.contains(tag::tile_offsets);
        const int offsets = tiled ? tag::tile_offsets : tag::strip_offsets,
                  counts = tiled ? tag::tile_bytes : tag::strip_bytes;
        const auto found = page.entries.find(offsets);
        if (found == page.entries.end() || !page.entries.contains(counts)) {
            fault = "damaged: its directory names no pixels";
            return {};
        }
        std::uint64_t total = 0;
        for (std::uint64_t i = 0; i < found->second.count; ++i) {
            const auto start = number(page, offsets, i), bytes = number(page, counts, i);
            if (!start || !bytes) fault = "damaged: its directory is incomplete";
            total += std::min(bytes.value_or(0), file_.size());
            if (total > file_.size()) fault = "truncated or damaged: its pixels are more than the file";
            if (!fault.empty()) return {};
            parts.push_back({*start, *bytes});
        }
    }
    for (const auto& part : parts) {
        const auto there = file_.size() - std::min(part.offset, file_.size());
        if (there >= part.bytes) continue;
        fault = fmt::format("truncated: {} of {} bytes of pixels at byte {}", there, part.bytes, part.offset);
        return {};
    }
    return parts;
}

/// Grey levels of pixels of at most 8 bits, whatever their colours.
FrameRead TiffStack::colours(const bytes::TiffPieces& pieces) const {
    const auto words = bytes::tiff_colours(source(), "TIFF", pieces, memory_for(pieces, file_.size()));
    FramePixels pixels(static_cast<long>(pieces.ny), static_cast<long>(pieces.nx));
    for (std::size_t i = 0; i < words.size(); ++i)
        pixels.data()[i] = luminance_of(words[i] & 255, (words[i] >> 8) & 255, (words[i] >> 16) & 255);
    return {std::move(pixels), {}};
}

bytes::Source TiffStack::source() const {
    return {file_.path(), file_.size(), file_.path(), [this](std::uint64_t offset, std::uint64_t count, char* target) {
                if (file_.read_into(target, offset, count) < count)
                    throw FileError(file_.path() + ": the file was cut while it was read");
            }};
}

FrameRead TiffStack::read(std::size_t index) const {
    const auto& page = pages_[index];
    if (!page.fault.empty()) return {{}, page.fault};
    const auto size = size_of(index);
    if (size.width <= 0 || size.height <= 0) return {{}, "damaged: its directory states no size"};
    std::string fault;
    const auto places = parts(page, fault);
    if (!fault.empty()) return {{}, fault};
    const auto channels = number(page, tag::samples).value_or(1), bits = number(page, tag::bits).value_or(1),
               photometric = number(page, tag::photometric).value_or(1);
    const bool tiled = page.entries.contains(tag::tile_offsets),
               raw = number(page, tag::compression).value_or(1) == 1 && !tiled;
    const auto type = sample_type(bits, number(page, tag::sample_format).value_or(1));
    const bool interleaved =
        channels >= 1 && channels <= 4 && (channels == 1 || number(page, tag::planar).value_or(1) == 1);
    RawPixels layout{.big_endian = big_endian_, .size = size};
    std::string values;
    if (raw && type && interleaved && photometric <= 2) {
        for (const auto& part : places) values += file_.read(part.offset, part.bytes);
        layout.type = *type;
    } else {
        bytes::TiffPieces pieces{.directory = page.directory,
                                 .nx = static_cast<std::uint64_t>(size.width),
                                 .ny = static_cast<std::uint64_t>(size.height),
                                 .tiled = tiled};
        pieces.piece_nx = tiled ? number(page, tag::tile_width).value_or(0) : pieces.nx;
        pieces.piece_ny = tiled ? number(page, tag::tile_height).value_or(0)
                                : std::min(number(page, tag::rows_a_strip).value_or(pieces.ny), pieces.ny);
        if (pieces.piece_nx == 0 || pieces.piece_ny == 0 ||
            (tiled && (pieces.piece_nx > most_tile_pixels || pieces.piece_ny > most_tile_pixels / pieces.piece_nx)))
            return {{}, fmt::format("damaged: tiles of {} × {} pixels", pieces.piece_nx, pieces.piece_ny)};
        if (bits <= 8) return colours(pieces);
        if (!type || !interleaved)
            return {{}, fmt::format("{} numbers of {} bits a pixel, which no picture has", channels, bits)};
        pieces.pixel_bytes = channels * bytes_of(*type);
        values = bytes::expanded_tiff(source(), "TIFF", pieces, memory_for(pieces, file_.size()));
        layout.type = *type;
        layout.big_endian = std::endian::native == std::endian::big;
    }
    auto pixels = pixels_in(values, layout, static_cast<int>(channels));
    if (!pixels)
        return {{},
                fmt::format("truncated: {} of {} bytes of pixels", values.size(),
                            static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                                channels * bits / 8)};
    FrameRead frame{std::move(*pixels), {}};
    if (photometric == 0) frame.pixels = frame.pixels.maxCoeff() - frame.pixels;  // white is 0
    return frame;
}

}  // namespace setae::imaging
