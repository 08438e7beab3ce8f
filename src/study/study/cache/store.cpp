// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/cache/store.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include <fmt/format.h>

#include "setae/bytes/digest.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::cache {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "setae cache", format = "setae cache 3\n";
constexpr std::string_view ending = ".entry";
constexpr std::size_t key_length = 64;

/// Content of the digest of an entry: links this content to this key.
std::string signed_part(const std::string& version, const std::string& key, std::string_view content) {
    return fmt::format("{}\n{}\n", version, key) + std::string(content);
}

/// First lines of an entry: format, version that wrote it, key, number of bytes that follow, digest of these and of the
/// content.
std::string header(const std::string& version, const std::string& key, std::string_view content) {
    return fmt::format("{}{}\n{}\n{}\n{}\n", format, version, key, content.size(),
                       bytes::sha256(signed_part(version, key, content)));
}

/// The line that begins at `at`, which moves to its end; empty without a line end.
std::optional<std::string> next_line(const std::string& text, std::size_t& at) {
    const auto end = text.find('\n', at);
    if (end == std::string::npos) return std::nullopt;
    auto line = text.substr(at, end - at);
    at = end + 1;
    return line;
}

enum class State { whole, damaged, of_other_version };

struct Entry {
    State state = State::damaged;
    std::string content;
};

/// Only the first lines are read where these are not those of the requested entry, or state another size than that of
/// the file. @throws FileError where it cannot be read.
Entry read_entry(const bytes::Source& file, const std::string& wanted_version, const std::string& wanted_key) {
    constexpr std::uint64_t longest_header = 4096;
    const auto head = file.head(longest_header);
    if (!head.starts_with(format)) return {head.starts_with(magic) ? State::of_other_version : State::damaged, {}};
    std::size_t at = format.size();
    const auto version = next_line(head, at), key = next_line(head, at), size = next_line(head, at),
               digest = next_line(head, at);
    if (!version || !key || !size || !digest) return {};
    if (*version != wanted_version) return {State::of_other_version, {}};
    if (*key != wanted_key || *size != fmt::format("{}", file.size - at)) return {};
    auto content = file.bytes(at, file.size - at);
    if (*digest != bytes::sha256(signed_part(*version, *key, content))) return {};
    return {State::whole, std::move(content)};
}

/// Two letters of the key name a folder, so that none holds too many files.
fs::path path_of(const std::string& folder, const std::string& key) {
    return fs::path(folder) / key.substr(0, 2) / (key + std::string(ending));
}

/// Empty for a missing file; a damaged entry where it cannot be read, such as a folder or a pipe in its place.
std::optional<Entry> entry_at(const fs::path& path, const std::string& version, const std::string& key) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(path, ignored))) return std::nullopt;
    try {
        return read_entry(bytes::own_source(path.string()), version, key);
    } catch (const std::exception&) {
        return Entry{};
    }
}

/// Removes a link, a pipe or an empty folder at the path of an entry.
void clear_place(const fs::path& path) {
    std::error_code ignored;
    const auto status = fs::symlink_status(path, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) fs::remove(path, ignored);
}

/// Whether an entry, by its first lines, is of another version; damaged ones are not.
bool is_of_other_version(const fs::path& path, const std::string& wanted) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string first, version;
    if (!std::getline(file, first) || !first.starts_with(magic)) return false;
    return first + "\n" != format || (std::getline(file, version) && version != wanted);
}

/// A name of path_of() within `group`, and whether it is a temporary file of a writer.
bool is_own_name(const std::string& name, const std::string& group, bool& whole) {
    const auto key = name.substr(0, key_length);
    const bool hexadecimal = key.size() == key_length && key.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!hexadecimal || !key.starts_with(group) || name.compare(key_length, ending.size(), ending) != 0) return false;
    const auto rest = std::string_view(name).substr(key_length + ending.size());
    whole = rest.empty();
    return whole || (rest.starts_with('.') && rest.ends_with(".part"));
}

/// Every file of a store: entries, and temporary files of interrupted writers. Other files in the folder are excluded.
void for_each_file(const std::string& folder, const std::function<void(const fs::directory_entry&, bool whole)>& body) {
    std::error_code ignored;
    for (const auto& group : fs::directory_iterator(folder, ignored)) {
        const auto letters = group.path().filename().string();
        if (letters.size() != 2 || !group.is_directory(ignored)) continue;
        for (const auto& file : fs::directory_iterator(group.path(), ignored)) {
            bool whole = false;
            if (is_own_name(file.path().filename().string(), letters, whole)) body(file, whole);
        }
    }
}

std::uintmax_t size_of(const fs::directory_entry& file) {
    std::error_code failure;
    const auto size = file.is_regular_file(failure) ? file.file_size(failure) : 0;
    return failure ? 0 : size;
}

std::optional<std::string> variable(const char* name) {
    const char* value = std::getenv(name);
    if (!value || !*value) return std::nullopt;
    return value;
}

}  // namespace

Store::Store(std::string folder, std::string version) : folder_(std::move(folder)), version_(std::move(version)) {}

std::optional<std::string> Store::find(const std::string& key) const {
    if (!enabled()) return std::nullopt;
    auto entry = entry_at(path_of(folder_, key), version_, key);
    if (!entry) return std::nullopt;
    switch (entry->state) {
        case State::whole: ++counters_.found; return std::move(entry->content);
        case State::of_other_version: ++counters_.other_version; return std::nullopt;
        case State::damaged: break;
    }
    ++counters_.damaged;
    return std::nullopt;
}

bool Store::holds(const std::string& key) const {
    if (!enabled()) return false;
    const auto entry = entry_at(path_of(folder_, key), version_, key);
    return entry && entry->state == State::whole;
}

void Store::keep(const std::string& key, std::string_view content) const {
    if (!enabled()) return;
    const auto path = path_of(folder_, key);
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    clear_place(path);
    try {
        bytes::write_unflushed_file(path.string(), {header(version_, key, content), content});
        ++counters_.kept;
    } catch (const FileError&) {
        ++counters_.not_kept;  // the result itself is fine
    }
}

Traffic Store::traffic() const {
    return {counters_.found, counters_.kept, counters_.damaged, counters_.other_version, counters_.not_kept};
}

Content Store::content() const {
    Content content;
    if (!enabled()) return content;
    for_each_file(folder_, [&](const fs::directory_entry& file, bool whole) {
        content.bytes += size_of(file);
        if (!whole) return;
        ++content.entries;
        if (is_of_other_version(file.path(), version_)) ++content.of_other_versions;
    });
    return content;
}

Content Store::remove(bool only_other_versions) const {
    Content removed;
    if (!enabled()) return removed;
    for_each_file(folder_, [&](const fs::directory_entry& file, bool whole) {
        const bool other = whole && is_of_other_version(file.path(), version_);
        if (whole && only_other_versions && !other) return;
        std::error_code failure;
        const auto size = size_of(file);
        if (!fs::remove(file.path(), failure) || failure) return;
        removed.bytes += size;
        removed.entries += whole ? 1 : 0;
        removed.of_other_versions += other ? 1 : 0;
    });
    return removed;
}

std::string default_folder() {
    if (const auto folder = variable("SETAE_CACHE")) return *folder;
    if (const auto folder = variable("XDG_CACHE_HOME")) return (fs::path(*folder) / "setae").string();
    if (const auto home = variable("HOME")) return (fs::path(*home) / ".cache" / "setae").string();
    return {};
}

}  // namespace setae::cache
