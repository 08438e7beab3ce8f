// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"
#include "setae/bytes/stored_numbers.hpp"

namespace setae::bytes {

/// Reads numbers and texts in sequence; a read beyond the end is refused with format, offset and reason. It reads
/// pieces of 64 KiB from the source, so headers are parsed without reading the data after them.
class Cursor {
public:
    Cursor(const Source& source, std::string format, std::uint64_t offset = 0, std::endian order = std::endian::little);

    template <class T>
    [[nodiscard]] T number() {
        return load<T>(take(sizeof(T)), order_);
    }
    /// A number at another place; the position does not change.
    template <class T>
    [[nodiscard]] T number_at(std::uint64_t offset) {
        const auto before = position_;
        seek(offset);
        const T value = number<T>();
        position_ = before;
        return value;
    }
    [[nodiscard]] std::string bytes(std::uint64_t count);
    /// `count` bytes as text: up to the first NUL, Latin-1 or UTF-8 converted to UTF-8, trimmed.
    [[nodiscard]] std::string text(std::uint64_t count);
    void skip(std::uint64_t count);
    /// @throws FormatError for an offset beyond the end.
    void seek(std::uint64_t offset);
    void set_order(std::endian order) { order_ = order; }

    [[nodiscard]] std::uint64_t position() const { return position_; }
    [[nodiscard]] std::uint64_t remaining() const { return source_.size - position_; }
    [[nodiscard]] bool at_end() const { return remaining() == 0; }
    [[nodiscard]] const Source& source() const { return source_; }
    /// @throws FormatError "<format>: <what>" at the position of the last number or text read.
    [[noreturn]] void fail(const std::string& what) const;

private:
    const char* take(std::uint64_t count);
    void require(std::uint64_t count) const;

    Source source_;
    std::string format_;
    std::uint64_t position_ = 0, last_ = 0;
    std::endian order_;
    std::string window_;
    std::uint64_t window_at_ = 0;
};

}  // namespace setae::bytes
