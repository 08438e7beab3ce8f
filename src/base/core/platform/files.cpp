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

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

FileFacts facts_of(const struct stat& found) {
    return {kind_of(found.st_mode),
            static_cast<std::uint64_t>(found.st_size),
            {found.st_dev, found.st_ino},
            nanoseconds(found.st_mtim),
            nanoseconds(found.st_ctim)};
}

std::optional<FileFacts> facts_of(int descriptor) {
    struct stat found {};
    if (::fstat(descriptor, &found) != 0) return std::nullopt;
    return facts_of(found);
}

std::error_code last_error() { return {errno, std::generic_category()}; }

}  // namespace

std::optional<FileFacts> facts_of(const std::string& path) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0) return std::nullopt;
    return facts_of(found);
}

ReadableFile::ReadableFile(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) {
        failure_ = last_error();
        facts_ = platform::facts_of(path);
        return;
    }
    facts_ = current_facts();
}

std::optional<FileFacts> ReadableFile::current_facts() const { return facts_of(descriptor_); }

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
    ::flock(lock, LOCK_UN);  // a child of this process may still have the descriptor
    ::close(lock);
}

bool is_locked(int lock, const std::string& folder) {
    const auto locked = facts_of(lock), found = facts_of(folder.empty() ? "." : folder);
    return locked && found && locked->identity == found->identity;
}

std::error_code make_new_file(const std::string& path, bool only_for_owner) {
    constexpr mode_t of_owner = 0600, of_new_files = 0666;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                            only_for_owner ? of_owner : of_new_files);
    if (file < 0) return last_error();
    ::close(file);
    return {};
}

std::error_code take_permissions(const std::string& path, const std::string& model) {
    constexpr mode_t of_all = 0777;
    struct stat kept {};
    if (::stat(model.c_str(), &kept) != 0 || !S_ISREG(kept.st_mode)) return {};
    const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return last_error();
    std::error_code failure;
    // only root may change the owner of a file; otherwise the writer owns the new file
    static_cast<void>(::fchown(file, kept.st_uid, kept.st_gid) == 0);
    if (::fchmod(file, kept.st_mode & of_all) != 0) failure = last_error();
    ::close(file);
    return failure;
}

std::error_code flush_to_disk(const std::string& path) {
    const int file = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return last_error();
    std::error_code failure;
    // file systems without flushing, EINVAL, have nothing to wait for
    if (::fsync(file) != 0 && errno != EINVAL) failure = last_error();
    ::close(file);
    return failure;
}

std::string new_folder(const std::string& beginning, std::error_code& failure) {
    auto path = beginning + "XXXXXX";
    if (::mkdtemp(path.data())) return path;
    failure = last_error();
    return {};
}

bool is_executable(const std::string& path) { return ::access(path.c_str(), X_OK) == 0; }

}  // namespace setae::platform
