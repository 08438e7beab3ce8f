// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::bytes {

/// While it exists, other processes and threads that lock the same folder wait. For a few reads and writes that must
/// not be divided, not for a computation. No effect on file systems without locks, or if the folder cannot be opened.
class FolderLock {
public:
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Whether the path still leads to the locked folder; false without a lock.
    [[nodiscard]] bool holds(const std::string& folder) const;

private:
    int lock_ = -1;
};

}  // namespace setae::bytes
