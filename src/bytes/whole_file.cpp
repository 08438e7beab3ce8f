// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/whole_file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <regex>
#include <system_error>

#include <fmt/format.h>

#include "setae/bytes/archive.hpp"
#include "setae/bytes/archive_folder.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/platform/files.hpp"
#include "setae/platform/memory.hpp"
#include "setae/platform/processes.hpp"

namespace setae::bytes {
namespace {

/// Why the system refuses a path, in words that say what to look at.
std::string refusal(const std::error_code& error) {
    switch (static_cast<std::errc>(error.value())) {
        case std::errc::no_such_file_or_directory: return "no such file";
        case std::errc::not_a_directory: return "no such file: a part of its path is no folder";
        case std::errc::permission_denied:
        case std::errc::operation_not_permitted: return "no permission to read it, or to enter a folder of its path";
        case std::errc::too_many_symbolic_link_levels: return "its symbolic links lead in a circle";
        case std::errc::filename_too_long: return "its name is too long";
        case std::errc::too_many_files_open:
        case std::errc::too_many_files_open_in_system: return "too many files are open; see `ulimit -n`";
        default: return "cannot be opened: " + error.message();
    }
}

/// What a path leads to in place of a file; nothing where that is one.
const char* other_kind(const std::optional<platform::FileFacts>& facts) {
    if (!facts) return nullptr;
    switch (facts->kind) {
        case platform::FileKind::regular: return nullptr;
        case platform::FileKind::folder: return "a folder";
        case platform::FileKind::pipe: return "a pipe";
        case platform::FileKind::socket: return "a socket";
        case platform::FileKind::device: return "a device";
    }
    throw InternalError("a kind of file without a name");
}

/// @throws FileError for a missing path, what is no regular file and what cannot be opened.
void require_file(const std::string& path, const platform::ReadableFile& file) {
    if (const char* const kind = other_kind(file.facts()))
        throw FileError(fmt::format("{}: is {}, expected a regular file", path, kind));
    if (file.failure()) throw FileError(fmt::format("{}: {}", path, refusal(file.failure())));
}

void read_from_file(const std::string& path, std::uint64_t offset, std::uint64_t count, char* target) {
    const platform::ReadableFile file(path);
    require_file(path, file);
    if (!file.read(offset, count, target))
        throw FileError(fmt::format("{}: reading {} bytes at byte {} failed", path, count, offset));
}

/// Refuses what lies beyond the end of a source.
void require_inside(const std::string& name, std::uint64_t size, std::uint64_t offset, std::uint64_t count) {
    if (offset > size || count > size - offset)
        throw FormatError(
            name, {.offset = size},
            fmt::format("the file ends here, expected {} bytes from byte {}; it is truncated", count, offset));
}

[[noreturn]] void refuse_writing(const std::string& path, const char* what, int error) {
    throw FileError(fmt::format("{}: cannot be {} ({}); check that the folder exists, is writable and has space", path,
                                what, std::strerror(error)));
}

/// What a path leads to where it is a link to a file, so that links stay what they are.
std::string target_of(const std::string& path) {
    std::error_code failure;
    if (!std::filesystem::is_symlink(path, failure)) return path;
    const auto target = std::filesystem::weakly_canonical(path, failure);
    return failure ? path : target.string();
}

/// @throws FileError for inputs, folders, pipes and devices.
void require_replaceable(const std::string& path) {
    if (const char* const kind = other_kind(platform::facts_of(path)))
        throw FileError(fmt::format("{}: is {}, expected the name of a file to write", path, kind));
    require_no_input(path);
}

/// A name beside `path` that no other writer of this or another process uses.
std::string temporary_name(const std::string& path) {
    static std::atomic<unsigned> counter{0};
    return fmt::format("{}.{}.{}.part", path, platform::this_process(), counter++);
}

/// The process a temporary name belongs to; nothing for other names.
std::optional<platform::ProcessId> writer_of(const std::string& name) {
    static const std::regex pattern(R"(.+\.([0-9]{1,9})\.[0-9]+\.part)");
    std::smatch match;
    if (!std::regex_match(name, match, pattern)) return std::nullopt;
    return spelled<platform::ProcessId>(match[1].str());
}

}  // namespace

std::string Source::bytes(std::uint64_t offset, std::uint64_t count) const {
    require_inside(name, size, offset, count);
    if (count > platform::memory_of_machine())
        throw FormatError(name, {.offset = offset},
                          fmt::format("{} bytes in one piece are more than the memory of this machine", count));
    std::string content(count, '\0');
    read_into(offset, count, content.data());
    return content;
}

std::string Source::up_to(std::uint64_t offset, std::uint64_t count) const {
    return offset < size ? bytes(offset, std::min(count, size - offset)) : std::string();
}

namespace {

Source source_of(const std::string& path) {
    const platform::ReadableFile file(path);
    require_file(path, file);
    Source source{path, file.facts() ? file.facts()->size : 0, path, {}};
    source.read_into = [path, size = source.size](std::uint64_t offset, std::uint64_t count, char* target) {
        require_inside(path, size, offset, count);
        read_from_file(path, offset, count, target);
    };
    return source;
}

/// The archive that a path leads into, as "a.zip" of "a.zip/scans/x.txt"; nothing where it leads into none.
std::optional<std::string> archive_on_the_way(const std::string& path) {
    for (auto slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1)) {
        const auto outer = path.substr(0, slash);
        const auto facts = platform::facts_of(outer);
        if (!facts) return std::nullopt;
        if (facts->kind == platform::FileKind::regular) return is_archive(outer) ? std::optional(outer) : std::nullopt;
    }
    return std::nullopt;
}

/// A member of an archive under the path that leads to it. @throws FileError where the archive has no such member.
Source member_source(const std::string& path, const std::string& outer) {
    const auto file = source_of(outer);
    const Archive archive(file);
    const auto name = path.substr(outer.size() + 1);
    if (!archive.has(name)) throw FileError(fmt::format("{}: no such file in the archive {}", path, outer));
    auto source = archive.member(name);
    source.name = path;
    protect_input(outer);
    return source;
}

}  // namespace

Source file_source(const std::string& path) {
    if (!platform::facts_of(path))
        if (const auto outer = archive_on_the_way(path)) return member_source(path, *outer);
    auto source = source_of(path);
    protect_input(path);
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

std::string read_back(const std::string& path) { return source_of(path).all(); }

void write_whole_file(const std::string& link, const std::function<void(const std::string&)>& write) {
    const auto path = target_of(link);
    require_replaceable(path);
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
    refuse_writing(path, "replaced", error.value());
}

void write_whole_file(const std::string& path, std::string_view content) { write_whole_file(path, {content}); }

void write_whole_file(const std::string& path, const std::function<void(const Write&)>& content) {
    write_whole_file(path, [&](const std::string& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        if (!file) refuse_writing(path, "created", errno);
        content([&](std::string_view piece) {
            file.write(piece.data(), static_cast<std::streamsize>(piece.size()));
            if (!file) refuse_writing(path, "written", errno);
        });
        file.close();
        if (!file) refuse_writing(path, "written", errno);
    });
}

void write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts) {
    write_whole_file(path, [&](const Write& write) {
        for (const auto part : parts) write(part);
    });
}

void remove_leftovers(const std::string& folder) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const auto writer = writer_of(entry.path().filename().string());
        const bool left = writer && *writer != platform::this_process() && platform::is_gone(*writer);
        if (left) std::filesystem::remove(entry.path(), ignored);
    }
}

}  // namespace setae::bytes
