// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/whole_file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
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

/// Reason why the system refuses a path, for messages.
std::string refusal(const std::error_code& error) {
    switch (static_cast<std::errc>(error.value())) {
        case std::errc::no_such_file_or_directory: return "no such file";
        case std::errc::not_a_directory: return "no such file: a part of its path is not a folder";
        case std::errc::permission_denied:
        case std::errc::operation_not_permitted: return "no permission to read it, or to enter a folder of its path";
        case std::errc::too_many_symbolic_link_levels: return "its symbolic links form a loop";
        case std::errc::filename_too_long: return "its name is too long";
        case std::errc::too_many_files_open:
        case std::errc::too_many_files_open_in_system: return "too many files are open; see `ulimit -n`";
        default: return "cannot be opened: " + error.message();
    }
}

/// Kind of the target of a path that is no file; empty for a file.
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

/// @throws FileError for a missing path, for anything but a regular file and for a file that cannot be opened.
void require_file(const std::string& path, const platform::ReadableFile& file) {
    if (const char* const kind = other_kind(file.facts()))
        throw FileError(fmt::format("{}: is {}, expected a regular file", path, kind));
    if (file.failure()) throw FileError(fmt::format("{}: {}", path, refusal(file.failure())));
}

bool is_same_content(const platform::FileFacts& a, const platform::FileFacts& b) {
    return a.identity == b.identity && a.size == b.size && a.changed == b.changed;
}

[[noreturn]] void refuse_changed(const std::string& path) {
    throw FileError(path +
                    ": another program changed the file while it was read; wait until the file is complete, or read "
                    "a copy");
}

std::string state_of(const platform::FileFacts& facts) {
    return fmt::format("{}:{} {} {} {}", facts.identity.first, facts.identity.second, facts.size, facts.changed,
                       facts.status_changed);
}

/// A file that is read in pieces, all with the content at opening. It stays open, so a file that is replaced is read to
/// its end; if many are open, it is opened again for each piece.
class HeldFile {
public:
    HeldFile(std::string path, const platform::FileFacts& facts, std::shared_ptr<const platform::ReadableFile> file)
        : path_(std::move(path)), facts_(facts) {
        keep(std::move(file));
    }
    HeldFile(const HeldFile&) = delete;
    HeldFile& operator=(const HeldFile&) = delete;
    ~HeldFile() {
        if (kept_) --kept_open();
    }

    /// @throws FileError if the bytes cannot be read, or another program changed the file since it was opened.
    void read(std::uint64_t offset, std::uint64_t count, char* target) {
        const auto file = opened();
        const bool whole = file->read(offset, count, target);
        const auto now = file->current_facts();
        if (!now || !is_same_content(*now, facts_)) refuse_changed(path_);
        if (!whole) throw FileError(fmt::format("{}: reading {} bytes at byte {} failed", path_, count, offset));
    }

private:
    using File = std::shared_ptr<const platform::ReadableFile>;

    static std::atomic<int>& kept_open() {
        static std::atomic<int> count{0};
        return count;
    }
    File opened() {
        const std::lock_guard lock(mutex_);
        if (kept_) return kept_;
        auto file = std::make_shared<const platform::ReadableFile>(path_);
        require_file(path_, *file);
        if (!file->facts() || !is_same_content(*file->facts(), facts_)) refuse_changed(path_);
        keep(file);
        return file;
    }
    void keep(File file) {
        constexpr int max_kept_open = 128;  // of the 1024 files that a process may usually have open
        if (++kept_open() <= max_kept_open) kept_ = std::move(file);
        else --kept_open();
    }

    const std::string path_;
    const platform::FileFacts facts_;
    std::mutex mutex_;
    File kept_;
};

/// Refuses a range beyond the end of a source.
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

/// Target of a path that is a link to a file, so that links are kept.
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

/// 16 unpredictable hexadecimal digits.
std::string unforeseen_digits() {
    std::random_device device;
    return fmt::format("{:08x}{:08x}", device(), device());
}

/// Creates an empty file next to `path` with a new, unpredictable name, readable by the readers of `path`.
std::string new_temporary_file(const std::string& path) {
    constexpr int max_tries = 100;
    constexpr std::size_t max_bytes_of_name = 200;  // of the 255 that a name may have
    const auto slash = path.rfind('/');
    const auto name_at = slash == std::string::npos ? 0 : slash + 1;
    const auto beginning = path.substr(0, name_at + max_bytes_of_name);
    std::error_code failure;
    for (int i = 0; i < max_tries; ++i) {
        auto name = fmt::format("{}.{}-{}.part", beginning, platform::this_process(), unforeseen_digits());
        failure = platform::make_new_file(name, platform::facts_of(path).has_value());
        if (!failure) return name;
        if (failure != std::errc::file_exists) break;
    }
    refuse_writing(path, "created", failure.value());
}

/// File and process of a temporary name.
struct Leftover {
    std::string name;
    platform::ProcessId writer = 0;
};

/// Empty for names that new_temporary_file() does not create.
std::optional<Leftover> leftover(const std::string& name) {
    static const std::regex pattern(R"((.+)\.([0-9]{1,9})-[0-9a-f]{16}\.part)");
    std::smatch match;
    if (!std::regex_match(name, match, pattern)) return std::nullopt;
    const auto writer = spelled<platform::ProcessId>(match[2].str());
    if (!writer) return std::nullopt;
    return Leftover{match[1].str(), *writer};
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
    const auto file = std::make_shared<const platform::ReadableFile>(path);
    require_file(path, *file);
    if (!file->facts()) throw FileError(path + ": its size cannot be determined");
    Source source{path, file->facts()->size, path, {}};
    source.read_into = [file = std::make_shared<HeldFile>(path, *file->facts(), file), path, size = source.size](
                           std::uint64_t offset, std::uint64_t count, char* target) {
        require_inside(path, size, offset, count);
        file->read(offset, count, target);
    };
    source.state = state_of(*file->facts());
    return source;
}

/// The archive in a path, as "a.zip" in "a.zip/scans/x.txt"; empty if there is none.
std::optional<std::string> archive_on_the_way(const std::string& path) {
    for (auto slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1)) {
        const auto outer = path.substr(0, slash);
        const auto facts = platform::facts_of(outer);
        if (!facts) return std::nullopt;
        if (facts->kind == platform::FileKind::regular) return is_archive(outer) ? std::optional(outer) : std::nullopt;
    }
    return std::nullopt;
}

/// A member of an archive with the path that leads to it. @throws FileError if the archive has no such member.
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

Source own_source(const std::string& path) { return source_of(path); }

std::string file_state(const std::string& path) {
    if (const auto facts = platform::facts_of(path)) return state_of(*facts);
    const auto outer = archive_on_the_way(path);
    return outer ? file_state(*outer) : std::string();
}

std::int64_t age_of_change(const std::string& path) {
    if (const auto facts = platform::facts_of(path)) {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count() - facts->status_changed;
    }
    const auto outer = archive_on_the_way(path);
    return outer ? age_of_change(*outer) : 0;
}

void require_unchanged(const Source& source) {
    if (!source.state.empty() && file_state(source.path) != source.state) refuse_changed(source.path);
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

namespace {

/// Whether a file is flushed to the disk before it replaces another.
enum class Flushed { no, yes };

void replace_file(const std::string& link, Flushed flushed, const std::function<void(const std::string&)>& write) {
    const auto path = target_of(link);
    require_replaceable(path);
    const auto temporary = new_temporary_file(path);
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
    auto error = platform::take_permissions(temporary, path);
    if (!error && flushed == Flushed::yes) error = platform::flush_to_disk(temporary);
    if (!error) std::filesystem::rename(temporary, path, error);
    if (error) {
        remove();
        refuse_writing(path, "replaced", error.value());
    }
    // the new content is in place; if the folder cannot be flushed, the old one may return after a power failure
    if (flushed == Flushed::yes)
        static_cast<void>(platform::flush_to_disk(std::filesystem::path(path).parent_path().string()));
}

void replace_by_pieces(const std::string& path, Flushed flushed, const std::function<void(const Write&)>& content) {
    replace_file(path, flushed, [&](const std::string& temporary) {
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

}  // namespace

void write_whole_file(const std::string& path, const std::function<void(const std::string&)>& write) {
    replace_file(path, Flushed::yes, write);
}

void write_whole_file(const std::string& path, std::string_view content) { write_whole_file(path, {content}); }

void write_whole_file(const std::string& path, const std::function<void(const Write&)>& content) {
    replace_by_pieces(path, Flushed::yes, content);
}

void write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts) {
    replace_by_pieces(path, Flushed::yes, [&](const Write& write) {
        for (const auto part : parts) write(part);
    });
}

void write_unflushed_file(const std::string& path, std::initializer_list<std::string_view> parts) {
    replace_by_pieces(path, Flushed::no, [&](const Write& write) {
        for (const auto part : parts) write(part);
    });
}

void remove_leftovers(const std::string& folder, const std::set<std::string>& names) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const auto left = leftover(entry.path().filename().string());
        const bool own = left && names.contains(left->name) && !entry.is_symlink(ignored);
        if (own && left->writer != platform::this_process() && platform::is_gone(left->writer))
            std::filesystem::remove(entry.path(), ignored);
    }
}

}  // namespace setae::bytes
