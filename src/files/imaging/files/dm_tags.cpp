// SPDX-License-Identifier: GPL-3.0-or-later
#include "dm_tags.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "micrograph_building.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"

namespace setae::imaging {
namespace {

/// Types of numbers in tags, as the files number them.
enum class DmType {
    int16 = 2,
    int32 = 3,
    uint16 = 4,
    uint32 = 5,
    float32 = 6,
    float64 = 7,
    boolean = 8,
    int8 = 9,
    uint8 = 10,
    int64 = 11,
    uint64 = 12
};

constexpr int deepest_group = 64;
constexpr std::uint64_t max_tags = 200'000;      // real files have some thousands
constexpr std::uint64_t longest_text = 16'384;   // characters; longer arrays of 16-bit numbers are data
constexpr std::uint64_t max_type_words = 1'000;  // of the description of a structure
constexpr std::uint64_t window_bytes = 1 << 16;

constexpr std::uint64_t kind_structure = 15, kind_string = 18, kind_array = 20;
constexpr int entry_group = 20, entry_data = 21;

std::optional<std::uint64_t> bytes_of_type(std::uint64_t type) {
    switch (type) {
        case 2:
        case 4: return 2;
        case 3:
        case 5:
        case 6: return 4;
        case 7:
        case 11:
        case 12: return 8;
        case 8:
        case 9:
        case 10: return 1;
        default: return std::nullopt;
    }
}

class TagReader {
public:
    explicit TagReader(const bytes::Source& file) : file_(file) {}

    DmTags read() {
        DmTags tags;
        tags.version = static_cast<int>(number(4));
        word_ = tags.version == 4 ? 8 : 4;
        const auto length = number(word_);
        if (length > file_.size)
            throw damaged(0, fmt::format("its header announces {} bytes, but the file has {}; it is truncated", length,
                                         file_.size));
        tags.big_endian = big_endian_ = number(4) == 0;
        tags.root = group(0);
        return tags;
    }

private:
    [[nodiscard]] FormatError damaged(std::uint64_t offset, const std::string& what) const {
        return {file_.name, {.offset = offset}, what};
    }

    /// Bytes at the place of reading, which moves on.
    std::string_view take(std::uint64_t count) {
        if (count > file_.size - at_)
            throw damaged(
                at_, fmt::format("expected {} bytes, but the file ends at byte {}; it is truncated or damaged", count,
                                 file_.size));
        if (at_ < window_at_ || at_ + count > window_at_ + window_.size()) {
            window_at_ = at_;
            window_ = file_.up_to(at_, std::max(count, window_bytes));
            if (window_.size() < count) throw damaged(at_, "the file became shorter while it was read");
        }
        const auto bytes = std::string_view(window_).substr(at_ - window_at_, count);
        at_ += count;
        return bytes;
    }

    std::uint64_t number(std::size_t bytes) { return bytes::number_in(take(bytes), 0, bytes, true); }

    DmTag group(int depth) {
        if (depth > deepest_group)
            throw damaged(at_,
                          fmt::format("groups of tags nested more than {} deep; the file is damaged", deepest_group));
        (void)take(2);  // sorted, open
        const auto begin = at_;
        const auto count = number(word_);
        if (count > (file_.size - at_) / 3)
            throw damaged(begin, fmt::format("a group of {} tags in the {} remaining bytes; the file is damaged", count,
                                             file_.size - at_));
        DmTag tag;
        tag.offset = at_;
        for (std::uint64_t i = 0; i < count; ++i) {
            if (++tags_ > max_tags) throw damaged(at_, fmt::format("more than {} tags; the file is damaged", max_tags));
            const auto entry_at = at_;
            const auto kind = static_cast<int>(number(1));
            if (kind != entry_group && kind != entry_data)
                throw damaged(entry_at, fmt::format("a tag of kind {}, expected {} or {}; the file is damaged", kind,
                                                    entry_group, entry_data));
            auto name = bytes::field_text(take(number(2)));
            if (word_ == 8) (void)take(8);  // bytes of the entry
            auto member = kind == entry_group ? group(depth + 1) : data();
            member.name = std::move(name);
            tag.tags.push_back(std::move(member));
        }
        return tag;
    }

    DmTag data() {
        const auto begin = at_;
        if (take(4) != "%%%%") throw damaged(begin, "the data of a tag lack the mark %%%%; the file is damaged");
        const auto words = number(word_);
        if (words == 0 || words > max_type_words)
            throw damaged(begin, fmt::format("a type described by {} numbers; the file is damaged", words));
        types_.clear();
        for (std::uint64_t i = 0; i < words; ++i) types_.push_back(number(word_));
        DmTag tag;
        tag.offset = at_;
        const auto kind = types_.front();
        if (const auto bytes = bytes_of_type(kind)) {
            tag.number = value(take(*bytes), kind);
            return tag;
        }
        if (kind == kind_string && words > 1) {
            tag.bytes = times(types_[1], 2, begin);
            keep_text(tag);
        } else if (kind == kind_array && words > 2) {
            const auto count = types_.back();
            tag.bytes = times(count, element_bytes(1, begin), begin);
            if (words == 3 && static_cast<DmType>(types_[1]) == DmType::uint16 && count <= longest_text) keep_text(tag);
        } else {
            tag.bytes = element_bytes(0, begin);
        }
        skip(tag, begin);
        return tag;
    }

    /// Bytes of one element whose type is described from `from` on.
    std::uint64_t element_bytes(std::size_t from, std::uint64_t begin) const {
        const auto kind = types_[from];
        if (const auto bytes = bytes_of_type(kind)) return *bytes;
        if (kind == kind_structure && from + 2 < types_.size()) {
            const auto fields = types_[from + 2];
            if (fields > (types_.size() - from - 3) / 2)
                throw damaged(
                    begin, fmt::format("a structure of {} fields without a description; the file is damaged", fields));
            std::uint64_t bytes = 0;
            for (std::uint64_t i = 0; i < fields; ++i) {
                const auto field = bytes_of_type(types_[from + 4 + 2 * i]);
                if (!field)
                    throw damaged(begin,
                                  fmt::format("a field of type {} in a structure is unknown, or the file is damaged",
                                              types_[from + 4 + 2 * i]));
                bytes += *field;
            }
            return bytes;
        }
        if (kind == kind_array && from + 2 < types_.size()) {
            const auto inner = element_bytes(from + 1, begin);
            return times(types_[types_.size() - 1 - from], inner, begin);  // the outermost count is last
        }
        throw damaged(begin, fmt::format("a tag of type {} is unknown, or the file is damaged", kind));
    }

    [[nodiscard]] std::uint64_t times(std::uint64_t count, std::uint64_t bytes, std::uint64_t begin) const {
        if (bytes > 0 && count > file_.size / bytes)
            throw damaged(
                begin, fmt::format("{} elements of {} bytes in a file of {} bytes; it is truncated or damaged", count,
                                   bytes, file_.size));
        return count * bytes;
    }

    void keep_text(DmTag& tag) {
        if (tag.bytes > 2 * longest_text) return;
        tag.text = bytes::utf16_field_text(take(tag.bytes), big_endian_);
        at_ = tag.offset;
    }

    void skip(const DmTag& tag, std::uint64_t begin) {
        if (tag.bytes > file_.size - tag.offset)
            throw damaged(
                begin,
                fmt::format(
                    "{} bytes of data, but the file ends {} bytes after their beginning; it is truncated or damaged",
                    tag.bytes, file_.size - tag.offset));
        at_ = tag.offset + tag.bytes;
    }

    [[nodiscard]] double value(std::string_view bytes, std::uint64_t type) const {
        const auto whole = bytes::number_in(bytes, 0, bytes.size(), big_endian_);
        switch (static_cast<DmType>(type)) {
            case DmType::int8: return static_cast<std::int8_t>(whole);
            case DmType::int16: return static_cast<std::int16_t>(whole);
            case DmType::int32: return static_cast<std::int32_t>(whole);
            case DmType::int64: return static_cast<double>(static_cast<std::int64_t>(whole));
            case DmType::float32: return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(whole)));
            case DmType::float64: return std::bit_cast<double>(whole);
            default: return static_cast<double>(whole);
        }
    }

    const bytes::Source& file_;
    std::size_t word_ = 4;
    bool big_endian_ = false;
    std::uint64_t at_ = 0, tags_ = 0, window_at_ = 0;
    std::string window_;
    std::vector<std::uint64_t> types_;
};

}  // namespace

const DmTag* DmTag::find(std::string_view path) const {
    const auto slash = path.find('/');
    const auto first = path.substr(0, slash);
    const DmTag* member = nullptr;
    if (const auto index = spelled<std::size_t>(first)) {
        if (*index < tags.size()) member = &tags[*index];
    } else {
        const auto found = std::find_if(tags.begin(), tags.end(), [&](const DmTag& tag) { return tag.name == first; });
        if (found != tags.end()) member = &*found;
    }
    return !member || slash == std::string_view::npos ? member : member->find(path.substr(slash + 1));
}

std::optional<double> DmTag::number_at(std::string_view path) const {
    const auto* tag = find(path);
    return tag ? tag->number : std::nullopt;
}

std::string DmTag::text_at(std::string_view path) const {
    const auto* tag = find(path);
    return tag ? tag->text : std::string();
}

bool is_dm(std::string_view head) {
    if (head.size() < 20) return false;
    const auto version = bytes::number_in(head, 0, 4, true);
    if (version != 3 && version != 4) return false;
    const auto order_at = version == 3 ? 8U : 12U;
    return bytes::number_in(head, order_at, 4, true) <= 1;
}

DmTags read_dm_tags(const bytes::Source& file) { return TagReader(file).read(); }

}  // namespace setae::imaging
