// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace setae::bytes {

/// Bytes a reader works on: a file on disk, read where asked, or a member of an archive in memory.
struct Source {
    std::string name;        ///< for messages: the path, or "container.zip: member"
    std::uint64_t size = 0;  ///< bytes
    std::string path;        ///< on disk; empty for a member of an archive
    /// exactly `count` bytes from `offset` into memory of the caller, from any thread
    std::function<void(std::uint64_t offset, std::uint64_t count, char* target)> read_into;
    std::string state = {};  ///< file_state() of a file on disk when it was opened; empty for others

    /// Exactly `count` bytes from `offset`. @throws FormatError where the source ends before; nothing is allocated
    /// then.
    [[nodiscard]] std::string bytes(std::uint64_t offset, std::uint64_t count) const;
    /// Up to `count` bytes from `offset`; fewer at the end of the source.
    [[nodiscard]] std::string up_to(std::uint64_t offset, std::uint64_t count) const;
    [[nodiscard]] std::string all() const { return bytes(0, size); }
    /// The first `count` bytes, or all where there are fewer.
    [[nodiscard]] std::string head(std::uint64_t count) const { return up_to(0, count); }
};

/// How much of a source tells its format.
inline constexpr std::size_t detection_bytes = 1 << 16;

/// A regular file on disk, an input from now on (ProtectedInputs); nothing is read yet. A path that goes on behind a
/// ZIP archive, as "archive.zip/folder/member", is that member.
/// @throws FileError for a missing path, what is no regular file and what cannot be opened.
[[nodiscard]] Source file_source(const std::string& path);

/// The same for what this library wrote and may write again: it is no input.
[[nodiscard]] Source own_source(const std::string& path);

/// What tells whether a file is still the one it was: device, number, size and times of change; empty where there is no
/// file. Of a path into an archive: that of the archive.
[[nodiscard]] std::string file_state(const std::string& path);

/// How long ago the content or status of a file changed [ns]; 0 where there is no file.
[[nodiscard]] std::int64_t age_of_change(const std::string& path);

/// For libraries that open a file by its name: that it is still what the source was opened as.
/// @throws FileError where another program changed or replaced it.
void require_unchanged(const Source& source);

/// Bytes in memory under a name.
[[nodiscard]] Source memory_source(std::string name, std::string content);

/// Part of a source, such as an archive behind a picture. @throws FormatError where the source ends before.
[[nodiscard]] Source part_of(const Source& source, std::string name, std::uint64_t offset, std::uint64_t count);

}  // namespace setae::bytes
