// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/tiff_file.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

// TIFF 6.0 (Adobe, 1992) and BigTIFF: a header of byte order, magic number and the offset of the first directory;
// directories of entries (tag, type, count, values or their offset), each ending with the offset of the next.
namespace setae::bytes {
namespace {

constexpr std::uint64_t longest_text = 1 << 20, max_directories = 1'000'000, max_entries = 1 << 16;

/// Bytes of one value of types 1 to 18; 0 for unknown ones.
std::uint64_t type_bytes(std::uint16_t type) {
    static constexpr std::array<std::uint8_t, 19> sizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    return type < sizes.size() ? sizes[type] : 0;
}

/// Numbers in sequence in bytes that were read for them, without further access to the file.
struct Numbers {
    std::string bytes;
    std::endian order = std::endian::little;
    std::uint64_t at = 0;

    template <class T>
    T next() {
        const T value = bytes::load<T>(bytes.data() + at, order);
        at += sizeof(T);
        return value;
    }
    /// A count or offset: 8 bytes in BigTIFF, otherwise 4.
    std::uint64_t next_long(bool big) { return big ? next<std::uint64_t>() : next<std::uint32_t>(); }
};

struct Header {
    std::endian order = std::endian::little;
    bool big = false;  ///< BigTIFF: counts and offsets of 8 bytes
    std::uint64_t first = 0;
};

[[noreturn]] void truncated(const Source& source, const std::string& format, const std::string& what) {
    throw FormatError(source.name, {.offset = source.size},
                      fmt::format("{}: the file ends here, {}; it is truncated or damaged", format, what));
}

Numbers numbers_at(const Source& source, const std::string& format, std::endian order, std::uint64_t offset,
                   std::uint64_t count) {
    if (offset > source.size || count > source.size - offset)
        truncated(source, format, fmt::format("expected {} bytes from byte {}", count, offset));
    return {source.bytes(offset, count), order};
}

Header header_of(const Source& source, const std::string& format) {
    Header header;
    header.order = source.head(1) == "M" ? std::endian::big : std::endian::little;
    header.big = numbers_at(source, format, header.order, 2, 2).next<std::uint16_t>() == 43;
    header.first =
        numbers_at(source, format, header.order, header.big ? 8 : 4, header.big ? 8 : 4).next_long(header.big);
    return header;
}

Numbers values_of(const TiffFile& file, const TiffTag& tag) {
    if (tag.here) return {std::string(tag.here->data(), tag.bytes()), file.order};
    return numbers_at(file.source, file.format, file.order, tag.offset, tag.bytes());
}

struct Directory {
    TiffPage page;
    std::uint64_t next = 0, bytes = 0;
};

/// The entry that begins at `at`; empty for unknown types.
std::optional<TiffTag> tag_of(Numbers& entry, std::uint64_t at, bool big, const Source& source,
                              const std::string& format) {
    TiffTag tag{.id = entry.next<std::uint16_t>(), .type = entry.next<std::uint16_t>()};
    tag.count = entry.next_long(big);
    const auto place = entry.at;
    const auto far = entry.next_long(big);
    const auto size = type_bytes(tag.type);
    if (size == 0) return std::nullopt;
    const bool here = tag.count <= (big ? 8 : 4) / size;
    if (!here && (tag.count > source.size / size || far > source.size || tag.count * size > source.size - far))
        truncated(source, format, fmt::format("tag {} announces {} values from byte {}", tag.id, tag.count, far));
    tag.offset = here ? at + (big ? 12 : 8) : far;
    if (here) std::copy_n(entry.bytes.data() + place, big ? 8 : 4, tag.here.emplace().data());
    return tag;
}

/// Message of an error without the name of the file.
std::string message_of(const FormatError& error, const Source& source) {
    return std::string(error.what()).substr(source.name.size() + 2);
}

Directory directory_at(const Source& source, const std::string& format, const Header& header, std::uint64_t offset,
                       Damage damage = Damage::refused) {
    const std::uint64_t head_bytes = header.big ? 8 : 2, entry_bytes = header.big ? 20 : 12,
                        next_bytes = header.big ? 8 : 4;
    auto head = numbers_at(source, format, header.order, offset, head_bytes);
    const auto entries = header.big ? head.next<std::uint64_t>() : head.next<std::uint16_t>();
    if (entries > max_entries)
        throw FormatError(source.name, {.offset = offset},
                          fmt::format("{}: a directory of {} entries; it is damaged", format, entries));
    auto body = numbers_at(source, format, header.order, offset + head_bytes, entries * entry_bytes + next_bytes);
    Directory directory{.page = {.offset = offset, .tags = {}}};
    for (std::uint64_t k = 0; k < entries; ++k) try {
            body.at = k * entry_bytes;
            if (const auto tag = tag_of(body, offset + head_bytes + k * entry_bytes, header.big, source, format))
                directory.page.tags.push_back(*tag);
        } catch (const FormatError& error) {
            if (damage == Damage::refused) throw;
            directory.page.lost = message_of(error, source);
        }
    body.at = entries * entry_bytes;
    directory.next = body.next_long(header.big);
    directory.bytes = head_bytes + body.bytes.size();
    return directory;
}

/// A value as a real number; empty for texts and untyped bytes.
std::optional<double> value_of(Numbers& numbers, std::uint16_t type) {
    switch (type) {
        case 1: return numbers.next<std::uint8_t>();
        case 3: return numbers.next<std::uint16_t>();
        case 4:
        case 13: return numbers.next<std::uint32_t>();
        case 5: {
            const double above = numbers.next<std::uint32_t>(), below = numbers.next<std::uint32_t>();
            return above / below;
        }
        case 6: return numbers.next<std::int8_t>();
        case 8: return numbers.next<std::int16_t>();
        case 9: return numbers.next<std::int32_t>();
        case 10: {
            const double above = numbers.next<std::int32_t>(), below = numbers.next<std::int32_t>();
            return above / below;
        }
        case 11: return static_cast<double>(numbers.next<float>());
        case 12: return numbers.next<double>();
        case 16:
        case 18: return static_cast<double>(numbers.next<std::uint64_t>());
        case 17: return static_cast<double>(numbers.next<std::int64_t>());
        default: return std::nullopt;
    }
}

}  // namespace

std::uint64_t TiffTag::bytes() const { return count * type_bytes(type); }

const TiffTag* TiffPage::find(std::uint16_t id) const {
    const auto found = std::find_if(tags.begin(), tags.end(), [id](const TiffTag& tag) { return tag.id == id; });
    return found == tags.end() ? nullptr : &*found;
}

std::optional<double> TiffFile::number(const TiffPage& page, std::uint16_t id) const {
    const auto* tag = page.find(id);
    if (!tag || tag->count == 0) return std::nullopt;
    auto first = *tag;
    first.count = 1;
    auto numbers = values_of(*this, first);
    return value_of(numbers, tag->type);
}

std::vector<std::uint64_t> TiffFile::integers(const TiffPage& page, std::uint16_t id, std::uint64_t most) const {
    const auto* tag = page.find(id);
    if (!tag) return {};
    if (tag->count > most)
        throw FormatError(source.name, {.offset = tag->offset},
                          fmt::format("{}: tag {} has {} numbers, expected at most {}", format, id, tag->count, most));
    const bool integral = tag->type == 3 || tag->type == 4 || tag->type == 13 || tag->type == 16 || tag->type == 18;
    if (!integral)
        throw FormatError(source.name, {.offset = tag->offset},
                          fmt::format("{}: tag {} is of type {}, expected integers", format, id, tag->type));
    auto numbers = values_of(*this, *tag);
    std::vector<std::uint64_t> values(tag->count);
    for (auto& value : values)
        value = tag->type == 3 ? numbers.next<std::uint16_t>() : numbers.next_long(type_bytes(tag->type) == 8);
    return values;
}

std::string TiffFile::text(const TiffPage& page, std::uint16_t id) const {
    const auto* tag = page.find(id);
    if (!tag) return {};
    const auto content = tag->here ? std::string(tag->here->data(), tag->bytes())
                                   : source.bytes(tag->offset, std::min(tag->bytes(), longest_text));
    return std::string(trimmed(field_text(content)));
}

TiffPage TiffFile::directory_of(const TiffPage& page, std::uint16_t id) const {
    const auto* tag = page.find(id);
    if (!tag)
        throw FormatError(source.name, {.offset = page.offset},
                          fmt::format("{}: this directory has no tag {}", format, id));
    const auto at = integers(page, id, 1);
    if (at.empty())
        throw FormatError(source.name, {.offset = tag->offset},
                          fmt::format("{}: tag {} is empty, expected the offset of a directory", format, id));
    return directory_at(source, format, header_of(source, format), at.front()).page;
}

bool is_tiff(std::string_view head) {
    using namespace std::string_view_literals;
    return head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv) ||
           head.starts_with("MM\0+"sv);
}

TiffFile open_tiff(const Source& source, const std::string& format, std::size_t max_pages, Damage damage) {
    const auto header = header_of(source, format);
    TiffFile file{.source = source, .format = format, .order = header.order, .pages = {}};
    std::set<std::uint64_t> seen;
    std::uint64_t bytes = 0;  // each part of a valid file is used once: overlapping parts could expand without limit
    const auto next_page = [&](std::uint64_t offset) {
        if (!seen.insert(offset).second || seen.size() > max_directories)
            throw FormatError(source.name, {.offset = offset},
                              format + ": its directories form a loop or are too many; it is damaged");
        auto directory = directory_at(source, format, header, offset, damage);
        bytes += directory.bytes;
        if (bytes > source.size)
            throw FormatError(source.name, {.offset = offset}, format + ": its directories overlap; it is damaged");
        file.pages.push_back(std::move(directory.page));
        return directory.next;
    };
    for (auto next = header.first; next != 0 && file.pages.size() < max_pages;) try {
            next = next_page(next);
        } catch (const FormatError& error) {
            if (damage == Damage::refused) throw;
            file.pages.push_back({.offset = next, .tags = {}, .fault = message_of(error, source)});
            break;
        }
    if (file.pages.empty())
        throw FormatError(source.name, {.offset = 0}, format + ": a TIFF file without a directory; it is damaged");
    return file;
}

}  // namespace setae::bytes
