// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/folder_lock.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace setae::bytes {

FolderLock::FolderLock(const std::string& folder)
    : descriptor_(open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) return;
    while (flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
}

FolderLock::~FolderLock() {
    if (descriptor_ < 0) return;
    flock(descriptor_, LOCK_UN);  // a child of this process may hold the descriptor still
    close(descriptor_);
}

}  // namespace setae::bytes
