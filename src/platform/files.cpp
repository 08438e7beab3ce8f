// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/platform/files.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace setae::platform {
namespace {

FileKind kind_of(mode_t mode) {
    if (S_ISREG(mode)) return FileKind::regular;
    if (S_ISDIR(mode)) return FileKind::folder;
    if (S_ISFIFO(mode)) return FileKind::pipe;
    if (S_ISSOCK(mode)) return FileKind::socket;
    return FileKind::device;
}

FileFacts facts_of(const struct stat& found) {
    return {kind_of(found.st_mode),
            static_cast<std::uint64_t>(found.st_size),
            {found.st_dev, found.st_ino},
            std::int64_t{found.st_mtim.tv_sec} * 1'000'000'000 + found.st_mtim.tv_nsec};
}

}  // namespace

std::optional<FileFacts> facts_of(const std::string& path) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0) return std::nullopt;
    return facts_of(found);
}

ReadableFile::ReadableFile(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) {
        failure_ = {errno, std::generic_category()};
        facts_ = platform::facts_of(path);
        return;
    }
    struct stat found {};
    if (::fstat(descriptor_, &found) == 0) facts_ = facts_of(found);
}

ReadableFile::~ReadableFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

bool ReadableFile::read(std::uint64_t offset, std::uint64_t count, char* target) const {
    while (count > 0) {
        const auto got = ::pread(descriptor_, target, count, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        target += got;
        offset += static_cast<std::uint64_t>(got);
        count -= static_cast<std::uint64_t>(got);
    }
    return true;
}

int lock_folder(const std::string& folder) {
    const int lock = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock < 0) return lock;
    while (::flock(lock, LOCK_EX) != 0 && errno == EINTR) {
    }
    return lock;
}

void unlock_folder(int lock) {
    if (lock < 0) return;
    ::flock(lock, LOCK_UN);  // a child of this process may hold the descriptor still
    ::close(lock);
}

std::string new_folder(const std::string& beginning, std::error_code& failure) {
    auto path = beginning + "XXXXXX";
    if (::mkdtemp(path.data())) return path;
    failure = {errno, std::generic_category()};
    return {};
}

bool is_executable(const std::string& path) { return ::access(path.c_str(), X_OK) == 0; }

}  // namespace setae::platform
