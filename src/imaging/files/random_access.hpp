// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace setae::imaging {

/// A file read in pieces from any thread.
class RandomAccess {
public:
    /// @throws FileError where it cannot be opened.
    explicit RandomAccess(const std::string& path);
    /// Bytes in memory read as if they were a file; they must outlive what reads them.
    RandomAccess(std::string name, std::string_view bytes);
    ~RandomAccess();
    RandomAccess(RandomAccess&& other) noexcept;
    RandomAccess& operator=(RandomAccess&&) = delete;

    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] const std::string& path() const { return path_; }
    /// Up to `count` bytes from `offset`; fewer at the end of the file. @throws FileError where the system fails.
    [[nodiscard]] std::string read(std::uint64_t offset, std::uint64_t count) const;
    /// The same into memory of the caller; the number of bytes read.
    std::uint64_t read_into(char* target, std::uint64_t offset, std::uint64_t count) const;
    /// The bytes, where they lie in memory; nothing of a file on disk.
    [[nodiscard]] std::optional<std::string_view> memory() const;

private:
    std::string path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    std::string_view memory_;  ///< where there is no descriptor
};

/// Whole number of `count` ≤ 8 bytes; the caller has checked that they are there.
[[nodiscard]] inline std::uint64_t number_in(std::string_view bytes, std::size_t offset, std::size_t count,
                                             bool big_endian = false) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[offset + (big_endian ? i : count - 1 - i)]);
        value = (value << 8) | byte;
    }
    return value;
}

}  // namespace setae::imaging
