// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/folder_lock.hpp"

#include "setae/platform/files.hpp"

namespace setae::bytes {

FolderLock::FolderLock(const std::string& folder) : lock_(platform::lock_folder(folder)) {}

FolderLock::~FolderLock() { platform::unlock_folder(lock_); }

}  // namespace setae::bytes
