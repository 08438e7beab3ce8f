// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiff_file.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "setae/bytes/bytes.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

// TIFF 6.0 (Adobe, 1992) and BigTIFF: a header of byte order, magic number and the offset of the first directory;
// directories of entries (tag, type, count, values or their offset), each ending with the offset of the next.
namespace setae::formats {
namespace {

constexpr std::uint64_t longest_text = 1 << 20, most_directories = 1 << 16, most_entries = 1 << 16;

/// Bytes of one value of types 1 to 18; 0 for unknown ones.
std::uint64_t type_bytes(std::uint16_t type) {
    static constexpr std::array<std::uint8_t, 19> sizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    return type < sizes.size() ? sizes[type] : 0;
}

/// Numbers one after another in bytes that were read for them, so that no more of the file is touched.
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
    /// A count or offset: 8 bytes in BigTIFF, else 4.
    std::uint64_t next_long(bool big) { return big ? next<std::uint64_t>() : next<std::uint32_t>(); }
};

struct Header {
    std::endian order = std::endian::little;
    bool big = false;  ///< BigTIFF: counts and offsets of 8 bytes
    std::uint64_t first = 0;
};

[[noreturn]] void truncated(const bytes::Source& source, const std::string& format, const std::string& what) {
    throw FormatError(source.name, {.offset = source.size},
                      fmt::format("{}: the file ends here, {}; it is truncated or damaged", format, what));
}

Numbers numbers_at(const bytes::Source& source, const std::string& format, std::endian order, std::uint64_t offset,
                   std::uint64_t count) {
    if (offset > source.size || count > source.size - offset)
        truncated(source, format, fmt::format("expected {} bytes from byte {}", count, offset));
    return {source.bytes(offset, count), order};
}

Header header_of(const bytes::Source& source, const std::string& format) {
    Header header;
    header.order = source.head(1) == "M" ? std::endian::big : std::endian::little;
    header.big = numbers_at(source, format, header.order, 2, 2).next<std::uint16_t>() == 43;
    header.first =
        numbers_at(source, format, header.order, header.big ? 8 : 4, header.big ? 8 : 4).next_long(header.big);
    return header;
}

struct Directory {
    TiffPage page;
    std::uint64_t next = 0;
};

/// The entry that begins at `at`; nothing for types this reader does not know.
std::optional<TiffTag> tag_of(Numbers& entry, std::uint64_t at, bool big, const bytes::Source& source,
                              const std::string& format) {
    TiffTag tag{.id = entry.next<std::uint16_t>(), .type = entry.next<std::uint16_t>()};
    tag.count = entry.next_long(big);
    const auto far = entry.next_long(big);
    const auto size = type_bytes(tag.type);
    if (size == 0) return std::nullopt;
    const bool here = tag.count <= (big ? 8 : 4) / size;
    if (!here && (tag.count > source.size / size || far > source.size || tag.count * size > source.size - far))
        truncated(source, format, fmt::format("tag {} announces {} values from byte {}", tag.id, tag.count, far));
    tag.offset = here ? at + (big ? 12 : 8) : far;
    return tag;
}

Directory directory_at(const bytes::Source& source, const std::string& format, const Header& header,
                       std::uint64_t offset) {
    const std::uint64_t head_bytes = header.big ? 8 : 2, entry_bytes = header.big ? 20 : 12,
                        next_bytes = header.big ? 8 : 4;
    auto head = numbers_at(source, format, header.order, offset, head_bytes);
    const auto entries = header.big ? head.next<std::uint64_t>() : head.next<std::uint16_t>();
    if (entries > most_entries)
        throw FormatError(source.name, {.offset = offset},
                          fmt::format("{}: a directory of {} entries; it is damaged", format, entries));
    auto body = numbers_at(source, format, header.order, offset + head_bytes, entries * entry_bytes + next_bytes);
    Directory directory{.page = {.offset = offset, .tags = {}}};
    for (std::uint64_t k = 0; k < entries; ++k)
        if (const auto tag = tag_of(body, offset + head_bytes + k * entry_bytes, header.big, source, format))
            directory.page.tags.push_back(*tag);
    directory.next = body.next_long(header.big);
    return directory;
}

/// A value as the real number it stands for; nothing for texts and bytes of no meaning.
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
    auto numbers = numbers_at(source, format, order, tag->offset, type_bytes(tag->type));
    return value_of(numbers, tag->type);
}

std::vector<std::uint64_t> TiffFile::integers(const TiffPage& page, std::uint16_t id, std::uint64_t most) const {
    const auto* tag = page.find(id);
    if (!tag) return {};
    if (tag->count > most)
        throw FormatError(
            source.name, {.offset = tag->offset},
            fmt::format("{}: tag {} holds {} numbers, expected at most {}", format, id, tag->count, most));
    const bool integral = tag->type == 3 || tag->type == 4 || tag->type == 13 || tag->type == 16 || tag->type == 18;
    if (!integral)
        throw FormatError(source.name, {.offset = tag->offset},
                          fmt::format("{}: tag {} is of type {}, expected integers", format, id, tag->type));
    auto numbers = numbers_at(source, format, order, tag->offset, tag->bytes());
    std::vector<std::uint64_t> values(tag->count);
    for (auto& value : values)
        value = tag->type == 3 ? numbers.next<std::uint16_t>() : numbers.next_long(type_bytes(tag->type) == 8);
    return values;
}

std::string TiffFile::text(const TiffPage& page, std::uint16_t id) const {
    const auto* tag = page.find(id);
    if (!tag) return {};
    auto content = source.bytes(tag->offset, std::min(tag->bytes(), longest_text));
    content.resize(std::min(content.find('\0'), content.size()));
    return std::string(trimmed(bytes::decoded(std::move(content), bytes::Encoding::detect)));
}

TiffPage TiffFile::directory_of(const TiffPage& page, std::uint16_t id) const {
    const auto* tag = page.find(id);
    if (!tag)
        throw FormatError(source.name, {.offset = page.offset},
                          fmt::format("{}: no tag {} in the directory here", format, id));
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

TiffFile open_tiff(const bytes::Source& source, const std::string& format, std::size_t most_pages) {
    const auto header = header_of(source, format);
    TiffFile file{.source = source, .format = format, .order = header.order, .pages = {}};
    std::set<std::uint64_t> seen;
    for (auto next = header.first; next != 0 && file.pages.size() < most_pages;) {
        if (!seen.insert(next).second || seen.size() > most_directories)
            throw FormatError(source.name, {.offset = next},
                              format + ": its directories form a loop or are too many; it is damaged");
        auto directory = directory_at(source, format, header, next);
        file.pages.push_back(std::move(directory.page));
        next = directory.next;
    }
    if (file.pages.empty()) throw FormatError(source.name, {.offset = 0}, format + ": a TIFF file without a directory");
    return file;
}

void refuse_tiff(const bytes::Source& source) {
    (void)open_tiff(source, "TIFF");
    throw FormatError(
        source.name, {.offset = 0},
        "a TIFF picture, it has none of the tags by which JPK, Park Systems and Olympus LEXT keep heights in TIFF; `setae contour` traces outlines in pictures, "
        "heights that were exported as grey values have lost their scale: export the instrument's own format");
}

}  // namespace setae::formats
