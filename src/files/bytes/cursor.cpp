// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/cursor.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::bytes {
namespace {

constexpr std::uint64_t window_bytes = 1 << 16;

}  // namespace

Cursor::Cursor(const Source& source, std::string format, std::uint64_t offset, std::endian order)
    : source_(source), format_(std::move(format)), order_(order) {
    seek(offset);
}

void Cursor::require(std::uint64_t count) const {
    if (count > remaining())
        throw FormatError(
            source_.name, {.offset = source_.size},
            fmt::format("{}: the file ends here, expected {} bytes from byte {}; it is truncated or damaged", format_,
                        count, position_));
}

const char* Cursor::take(std::uint64_t count) {
    require(count);
    if (position_ < window_at_ || position_ + count > window_at_ + window_.size()) {
        // windows begin at multiples of their size: the first contains the part of an archive member that is available
        // without expansion
        const auto begin = position_ - position_ % window_bytes;
        window_ =
            source_.bytes(begin, std::min(std::max(window_bytes, position_ + count - begin), source_.size - begin));
        window_at_ = begin;
    }
    last_ = position_;
    position_ += count;
    return window_.data() + (last_ - window_at_);
}

std::string Cursor::bytes(std::uint64_t count) {
    if (count <= window_bytes) {
        const char* from = take(count);
        return {from, count};
    }
    require(count);
    last_ = std::exchange(position_, position_ + count);
    return source_.bytes(last_, count);
}

std::string Cursor::text(std::uint64_t count) { return std::string(trimmed(field_text(bytes(count)))); }

void Cursor::skip(std::uint64_t count) {
    require(count);
    last_ = std::exchange(position_, position_ + count);
}

void Cursor::seek(std::uint64_t offset) {
    if (offset > source_.size)
        throw FormatError(source_.name, {.offset = source_.size},
                          fmt::format("{}: the file ends here, expected more at byte {}; it is truncated or damaged",
                                      format_, offset));
    position_ = last_ = offset;
}

void Cursor::fail(const std::string& what) const {
    throw FormatError(source_.name, {.offset = last_}, format_ + ": " + what);
}

}  // namespace setae::bytes
