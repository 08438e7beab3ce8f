// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace setae::platform {

enum class FileKind { regular, folder, pipe, socket, device };

/// Device and number on it: the same for every name of a file.
using FileIdentity = std::pair<std::uint64_t, std::uint64_t>;

struct FileFacts {
    FileKind kind = FileKind::regular;
    std::uint64_t size = 0;  ///< [byte]
    FileIdentity identity;
    std::int64_t changed = 0;         ///< when its content last changed [ns]; a program may set it back
    std::int64_t status_changed = 0;  ///< when its content, name or permission last changed [ns]

    friend bool operator==(const FileFacts&, const FileFacts&) = default;
};

/// Of what a path leads to, through links; nothing where that cannot be told.
[[nodiscard]] std::optional<FileFacts> facts_of(const std::string& path);

/// A file open to be read at any place, which closes itself. Opening never waits, not even for the other end of a pipe.
class ReadableFile {
public:
    explicit ReadableFile(const std::string& path);
    ReadableFile(const ReadableFile&) = delete;
    ReadableFile& operator=(const ReadableFile&) = delete;
    ~ReadableFile();

    /// Why it is not open, of the generic category; 0 where it is.
    [[nodiscard]] std::error_code failure() const { return failure_; }
    /// Of what was opened, or of what could not be.
    [[nodiscard]] const std::optional<FileFacts>& facts() const { return facts_; }
    /// Of the open file now: others than facts() where another program wrote into it.
    [[nodiscard]] std::optional<FileFacts> current_facts() const;
    /// `count` bytes from `offset` on; false where not all of them are to be had.
    [[nodiscard]] bool read(std::uint64_t offset, std::uint64_t count, char* target) const;

private:
    int descriptor_ = -1;
    std::error_code failure_;
    std::optional<FileFacts> facts_;
};

/// Waits until no other process, and no other thread, has the folder locked. @returns what unlock_folder() takes, below
/// 0 where the folder cannot be opened; where a file system has no locks nobody waits.
[[nodiscard]] int lock_folder(const std::string& folder);
void unlock_folder(int lock);
/// Whether the path still leads to the folder that is locked, which another process may have removed or replaced.
[[nodiscard]] bool is_locked(int lock, const std::string& folder);

/// Makes an empty file of a name that nothing has; no link is followed. for_owner_alone: nobody else may read it.
/// @returns why it cannot be made, of the generic category.
[[nodiscard]] std::error_code make_new_file(const std::string& path, bool for_owner_alone);
/// Gives a file the permissions of another one, and its owner where the system allows; nothing where that is no file.
[[nodiscard]] std::error_code take_permissions(const std::string& path, const std::string& model);
/// Waits until the content of a file, or the names in a folder, are on the disk. @returns why they are not.
[[nodiscard]] std::error_code flush_to_disk(const std::string& path);

/// Makes a folder of a name that no other has, beginning with `beginning`. @returns its path, empty with `failure`.
[[nodiscard]] std::string new_folder(const std::string& beginning, std::error_code& failure);

/// Whether this process may run the file as a program.
[[nodiscard]] bool is_executable(const std::string& path);

}  // namespace setae::platform
