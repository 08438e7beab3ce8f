// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/whole_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <regex>

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"

namespace setae::bytes {
namespace {

/// An open file that closes itself.
class Descriptor {
public:
    /// @throws FileError for a missing path, a folder or a file that cannot be opened.
    explicit Descriptor(const std::string& path) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) throw FileError(fmt::format("{}: no such file", path));
        if (std::filesystem::is_directory(path, ignored))
            throw FileError(fmt::format("{}: is a folder, expected a file", path));
        number_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        if (number_ < 0) throw FileError(fmt::format("{}: cannot be opened for reading; check its permissions", path));
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { ::close(number_); }

    [[nodiscard]] int number() const { return number_; }

private:
    int number_ = -1;
};

void read_from_file(const std::string& path, std::uint64_t offset, std::uint64_t count, char* target) {
    const Descriptor file(path);
    while (count > 0) {
        const auto got = ::pread(file.number(), target, count, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) throw FileError(fmt::format("{}: reading {} bytes at byte {} failed", path, count, offset));
        target += got;
        offset += static_cast<std::uint64_t>(got);
        count -= static_cast<std::uint64_t>(got);
    }
}

/// Refuses what lies beyond the end of a source.
void require_inside(const std::string& name, std::uint64_t size, std::uint64_t offset, std::uint64_t count) {
    if (offset > size || count > size - offset)
        throw FormatError(
            name, {.offset = size},
            fmt::format("the file ends here, expected {} bytes from byte {}; it is truncated", count, offset));
}

[[noreturn]] void refuse_writing(const std::string& path, const char* what) {
    throw FileError(
        fmt::format("{}: cannot be {}; check that the folder exists, is writable and has space", path, what));
}

/// A name beside `path` that no other writer of this or another process uses.
std::string temporary_name(const std::string& path) {
    static std::atomic<unsigned> counter{0};
    return fmt::format("{}.{}.{}.part", path, getpid(), counter++);
}

/// The process a temporary name belongs to; nothing for other names.
std::optional<pid_t> writer_of(const std::string& name) {
    static const std::regex pattern(R"(.+\.([0-9]{1,9})\.[0-9]+\.part)");
    std::smatch match;
    if (!std::regex_match(name, match, pattern)) return std::nullopt;
    return spelled<pid_t>(match[1].str());
}

}  // namespace

std::string Source::bytes(std::uint64_t offset, std::uint64_t count) const {
    require_inside(name, size, offset, count);
    std::string content(count, '\0');
    read_into(offset, count, content.data());
    return content;
}

std::string Source::up_to(std::uint64_t offset, std::uint64_t count) const {
    return offset < size ? bytes(offset, std::min(count, size - offset)) : std::string();
}

Source file_source(const std::string& path) {
    const Descriptor file(path);
    const auto end = ::lseek(file.number(), 0, SEEK_END);
    if (end < 0) throw FileError(fmt::format("{}: cannot be read; expected a regular file", path));
    Source source{path, static_cast<std::uint64_t>(end), path, {}};
    source.read_into = [path, size = source.size](std::uint64_t offset, std::uint64_t count, char* target) {
        require_inside(path, size, offset, count);
        read_from_file(path, offset, count, target);
    };
    return source;
}

Source memory_source(std::string name, std::string content) {
    const auto shared = std::make_shared<const std::string>(std::move(content));
    Source source{std::move(name), shared->size(), {}, {}};
    source.read_into = [shared, label = source.name](std::uint64_t offset, std::uint64_t count, char* target) {
        require_inside(label, shared->size(), offset, count);
        std::copy_n(shared->data() + offset, count, target);
    };
    return source;
}

Source part_of(const Source& source, std::string name, std::uint64_t offset, std::uint64_t count) {
    require_inside(source.name, source.size, offset, count);
    Source part{std::move(name), count, {}, {}};
    part.read_into = [whole = source, label = part.name, offset, size = count](std::uint64_t from, std::uint64_t length,
                                                                               char* target) {
        require_inside(label, size, from, length);
        whole.read_into(offset + from, length, target);
    };
    return part;
}

std::string read_file(const std::string& path) { return file_source(path).all(); }

void write_whole_file(const std::string& path, const std::function<void(const std::string&)>& write) {
    const auto temporary = temporary_name(path);
    const auto remove = [&] {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
    };
    try {
        write(temporary);
    } catch (...) {
        remove();
        throw;
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (!error) return;
    remove();
    refuse_writing(path, "replaced");
}

void write_whole_file(const std::string& path, std::string_view content) { write_whole_file(path, {content}); }

void write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts) {
    write_whole_file(path, [&](const std::string& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        if (!file) refuse_writing(path, "created");
        for (const auto part : parts) file.write(part.data(), static_cast<std::streamsize>(part.size()));
        file.close();
        if (!file) refuse_writing(path, "written");
    });
}

void remove_leftovers(const std::string& folder) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const auto writer = writer_of(entry.path().filename().string());
        const bool gone = writer && *writer != getpid() && kill(*writer, 0) != 0 && errno == ESRCH;
        if (gone) std::filesystem::remove(entry.path(), ignored);
    }
}

}  // namespace setae::bytes
