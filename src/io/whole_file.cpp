// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/whole_file.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <regex>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/io/source.hpp"

namespace setae::io {
namespace {

std::ifstream opened(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) throw FileError(fmt::format("{}: no such file", path));
    if (std::filesystem::is_directory(path, ignored))
        throw FileError(fmt::format("{}: is a folder, expected a file", path));
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(fmt::format("{}: cannot be opened for reading; check its permissions", path));
    return file;
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
    return static_cast<pid_t>(std::stol(match[1]));
}

}  // namespace

Source file_source(const std::string& path) {
    auto file = std::make_shared<std::ifstream>(opened(path));
    file->seekg(0, std::ios::end);
    const auto end = file->tellg();
    if (end < 0) throw FileError(fmt::format("{}: cannot be read; expected a regular file", path));
    Source source{path, static_cast<std::uint64_t>(end), path, {}};
    source.bytes = [path, size = source.size](std::uint64_t offset, std::uint64_t count) {
        if (offset > size || count > size - offset)
            throw FormatError(path, {.offset = size},
                              fmt::format("the file ends here, expected {} bytes from byte {}; it is truncated", count, offset));
        auto stream = opened(path);
        std::string content(count, '\0');
        stream.seekg(static_cast<std::streamoff>(offset));
        stream.read(content.data(), static_cast<std::streamsize>(count));
        if (!stream && count > 0) throw FileError(fmt::format("{}: reading {} bytes at byte {} failed", path, count, offset));
        return content;
    };
    return source;
}

Source memory_source(std::string name, std::string content) {
    const auto shared = std::make_shared<const std::string>(std::move(content));
    Source source{std::move(name), shared->size(), {}, {}};
    source.bytes = [shared, label = source.name](std::uint64_t offset, std::uint64_t count) {
        if (offset > shared->size() || count > shared->size() - offset)
            throw FormatError(label, {.offset = shared->size()},
                              fmt::format("the content ends here, expected {} bytes from byte {}; it is truncated", count, offset));
        return shared->substr(offset, count);
    };
    return source;
}

std::string read_file(const std::string& path) { return file_source(path).all(); }

void write_whole_file(const std::string& path, std::string_view content) {
    const auto temporary = temporary_name(path);
    const auto fail = [&](const char* what) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw FileError(fmt::format("{}: cannot be {}; check that the folder exists, is writable and has space", path, what));
    };
    {
        std::ofstream file(temporary, std::ios::binary);
        if (!file) fail("created");
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        file.close();
        if (!file) fail("written");
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error) fail("replaced");
}

void remove_leftovers(const std::string& folder) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const auto writer = writer_of(entry.path().filename().string());
        const bool gone = writer && *writer != getpid() && kill(*writer, 0) != 0 && errno == ESRCH;
        if (gone) std::filesystem::remove(entry.path(), ignored);
    }
}

}  // namespace setae::io
