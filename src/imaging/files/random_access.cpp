// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_access.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "setae/core/errors.hpp"

namespace setae::imaging {

RandomAccess::RandomAccess(const std::string& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw FileError(path + ": cannot open: " + std::strerror(errno));
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(descriptor_);
        throw FileError(path + ": no regular file");
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
}

RandomAccess::RandomAccess(std::string name, std::string_view bytes)
    : path_(std::move(name)), size_(bytes.size()), memory_(bytes) {}

RandomAccess::~RandomAccess() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

RandomAccess::RandomAccess(RandomAccess&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      memory_(other.memory_) {}

std::uint64_t RandomAccess::read_into(char* target, std::uint64_t offset, std::uint64_t count) const {
    if (offset >= size_) return 0;
    count = std::min(count, size_ - offset);
    if (descriptor_ < 0) {
        std::memcpy(target, memory_.data() + offset, count);
        return count;
    }
    std::uint64_t done = 0;
    while (done < count) {
        const auto got = ::pread(descriptor_, target + done, count - done, static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw FileError(path_ + ": cannot read: " + std::strerror(errno));
        if (got == 0) break;  // it was cut while we read
        done += static_cast<std::uint64_t>(got);
    }
    return done;
}

std::string RandomAccess::read(std::uint64_t offset, std::uint64_t count) const {
    if (offset >= size_) return {};
    std::string bytes(std::min(count, size_ - offset), '\0');
    bytes.resize(read_into(bytes.data(), offset, bytes.size()));
    return bytes;
}

std::optional<std::string_view> RandomAccess::memory() const {
    return descriptor_ < 0 ? std::optional(memory_) : std::nullopt;
}

}  // namespace setae::imaging
