// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/folder_lock.hpp"

#include "setae/platform/files.hpp"

namespace setae::bytes {

FolderLock::FolderLock(const std::string& folder) : lock_(platform::lock_folder(folder)) {}

FolderLock::~FolderLock() { platform::unlock_folder(lock_); }

bool FolderLock::holds(const std::string& folder) const { return lock_ >= 0 && platform::is_locked(lock_, folder); }

}  // namespace setae::bytes
