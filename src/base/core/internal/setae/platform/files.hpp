// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace setae::platform {

enum class FileKind { regular, folder, pipe, socket, device };

/// Device and file number: equal for every name of a file.
using FileIdentity = std::pair<std::uint64_t, std::uint64_t>;

struct FileFacts {
    FileKind kind = FileKind::regular;
    std::uint64_t size = 0;  ///< [byte]
    FileIdentity identity;
    std::int64_t changed = 0;         ///< time of the last change of content [ns]; programs can set it back
    std::int64_t status_changed = 0;  ///< time of the last change of content, name or permission [ns]

    friend bool operator==(const FileFacts&, const FileFacts&) = default;
};

/// Facts of the target of a path, through links; empty if they cannot be determined.
[[nodiscard]] std::optional<FileFacts> facts_of(const std::string& path);

/// A file open for reading at any place; the destructor closes it. Opening never waits, not even for the other end of a
/// pipe.
class ReadableFile {
public:
    explicit ReadableFile(const std::string& path);
    ReadableFile(const ReadableFile&) = delete;
    ReadableFile& operator=(const ReadableFile&) = delete;
    ~ReadableFile();

    /// Why it is not open, of the generic category; 0 if it is open.
    [[nodiscard]] std::error_code failure() const { return failure_; }
    /// Facts of the opened file, or of the path that could not be opened.
    [[nodiscard]] const std::optional<FileFacts>& facts() const { return facts_; }
    /// Facts of the open file now; they differ from facts() if another program wrote into the file.
    [[nodiscard]] std::optional<FileFacts> current_facts() const;
    /// Reads `count` bytes from `offset` on; false if they are not all available.
    [[nodiscard]] bool read(std::uint64_t offset, std::uint64_t count, char* target) const;

private:
    int descriptor_ = -1;
    std::error_code failure_;
    std::optional<FileFacts> facts_;
};

/// Waits until no other process or thread has locked the folder. @returns a handle for unlock_folder(), negative if the
/// folder cannot be opened. Does not wait on file systems without locks.
[[nodiscard]] int lock_folder(const std::string& folder);
void unlock_folder(int lock);
/// Whether the path still leads to the locked folder; another process may have removed or replaced it.
[[nodiscard]] bool is_locked(int lock, const std::string& folder);

/// Creates an empty file with a new name; links are not followed. only_for_owner: only the owner may read it. @returns
/// the reason of a failure, of the generic category.
[[nodiscard]] std::error_code make_new_file(const std::string& path, bool only_for_owner);
/// Gives a file the permissions of another file, and its owner if the system allows it; no effect if the other is not a
/// file.
[[nodiscard]] std::error_code take_permissions(const std::string& path, const std::string& model);
/// Waits until the content of a file, or the names in a folder, are on the disk. @returns the reason of a failure.
[[nodiscard]] std::error_code flush_to_disk(const std::string& path);

/// Creates a folder with a new name that begins with `beginning`. @returns its path; empty with `failure`.
[[nodiscard]] std::string new_folder(const std::string& beginning, std::error_code& failure);

/// Whether this process may run the file as a program.
[[nodiscard]] bool is_executable(const std::string& path);

}  // namespace setae::platform
