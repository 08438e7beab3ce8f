// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::bytes {

/// Keeps other processes that lock the same folder waiting for as long as it lives; threads of this process too. For a
/// few reads and writes that must not be divided, not for a computation. Where a file system has no locks, or the
/// folder cannot be opened, nobody waits.
class FolderLock {
public:
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Whether the path still leads to the folder that is locked; false where none is.
    [[nodiscard]] bool holds(const std::string& folder) const;

private:
    int lock_ = -1;
};

}  // namespace setae::bytes
