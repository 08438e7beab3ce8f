// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace setae::bytes {

/// Bytes for a reader: a file on disk, read on request, or a member of an archive in memory.
struct Source {
    std::string name;        ///< for messages: the path, or "container.zip: member"
    std::uint64_t size = 0;  ///< bytes
    std::string path;        ///< on disk; empty for a member of an archive
    /// exactly `count` bytes from `offset` into memory of the caller, from any thread
    std::function<void(std::uint64_t offset, std::uint64_t count, char* target)> read_into;
    std::string state = {};  ///< file_state() of a file on disk at opening; empty otherwise

    /// Exactly `count` bytes from `offset`. @throws FormatError if the source is shorter; no memory is allocated in
    /// this case.
    [[nodiscard]] std::string bytes(std::uint64_t offset, std::uint64_t count) const;
    /// Up to `count` bytes from `offset`; fewer at the end of the source.
    [[nodiscard]] std::string up_to(std::uint64_t offset, std::uint64_t count) const;
    [[nodiscard]] std::string all() const { return bytes(0, size); }
    /// The first `count` bytes, or all bytes of a shorter source.
    [[nodiscard]] std::string head(std::uint64_t count) const { return up_to(0, count); }
};

/// Number of bytes used to detect the format of a source.
inline constexpr std::size_t detection_bytes = 1 << 16;

/// A regular file on disk, registered as input (ProtectedInputs); nothing is read yet. A path that continues after a
/// ZIP archive, as "archive.zip/folder/member", is that member.
/// @throws FileError for a missing path, for anything but a regular file and for a file that cannot be opened.
[[nodiscard]] Source file_source(const std::string& path);

/// A regular file on disk that this library wrote and may overwrite: it is not registered as input.
[[nodiscard]] Source own_source(const std::string& path);

/// Identifies the state of a file: device, number, size and times of change; empty if there is no file. For a path into
/// an archive: that of the archive.
[[nodiscard]] std::string file_state(const std::string& path);

/// Time since the last change of content or status of a file [ns]; 0 if there is no file.
[[nodiscard]] std::int64_t age_of_change(const std::string& path);

/// Checks that a file is unchanged since the source was opened; for libraries that open a file by its name.
/// @throws FileError if another program changed or replaced the file.
void require_unchanged(const Source& source);

/// Bytes in memory with a name.
[[nodiscard]] Source memory_source(std::string name, std::string content);

/// Part of a source, such as an archive after a picture. @throws FormatError if the source is shorter.
[[nodiscard]] Source part_of(const Source& source, std::string name, std::uint64_t offset, std::uint64_t count);

}  // namespace setae::bytes
