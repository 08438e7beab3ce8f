// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/cache/store.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "setae/bytes/digest.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::cache {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "setae cache 1\n";
constexpr const char* ending = ".entry";

/// First lines of an entry: what it is, the version that wrote it, the digest of what follows.
std::string header(const std::string& version, std::string_view content) {
    return fmt::format("{}{}\n{}\n", magic, version, bytes::sha256(content));
}

struct Entry {
    std::string version, digest;
    std::string content;
};

/// The line that begins at `at`, which moves behind it; nothing where no line ends.
std::optional<std::string> next_line(const std::string& text, std::size_t& at) {
    const auto end = text.find('\n', at);
    if (end == std::string::npos) return std::nullopt;
    auto line = text.substr(at, end - at);
    at = end + 1;
    return line;
}

std::optional<Entry> parsed(const std::string& bytes) {
    if (bytes.compare(0, magic.size(), magic) != 0) return std::nullopt;
    std::size_t at = magic.size();
    const auto version = next_line(bytes, at), digest = next_line(bytes, at);
    if (!version || !digest) return std::nullopt;
    return Entry{*version, *digest, bytes.substr(at)};
}

/// Two letters of the key name a folder, so that none holds too many files.
fs::path path_of(const std::string& folder, const std::string& key) {
    return fs::path(folder) / key.substr(0, 2) / (key + ending);
}

std::optional<std::string> bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

/// The version an entry names, from its first lines alone; nothing where they are damaged.
std::optional<std::string> version_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string first, second;
    if (!std::getline(file, first) || !std::getline(file, second) || first + "\n" != magic) return std::nullopt;
    return second;
}

/// Every file of a store: entries, and what interrupted writers left of them. Other files in the folder are not its
/// own.
void for_each_file(const std::string& folder, const std::function<void(const fs::directory_entry&, bool whole)>& body) {
    std::error_code ignored;
    for (const auto& group : fs::directory_iterator(folder, ignored)) {
        if (group.path().filename().string().size() != 2 || !group.is_directory(ignored)) continue;
        for (const auto& file : fs::directory_iterator(group.path(), ignored)) {
            const auto name = file.path().filename().string();
            const bool whole = file.path().extension() == ending,
                       part = name.find(std::string(ending) + ".") != std::string::npos;
            if (whole || part) body(file, whole);
        }
    }
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
    const auto bytes = bytes_of(path_of(folder_, key));
    if (!bytes) return std::nullopt;
    auto entry = parsed(*bytes);
    if (entry && entry->version != version_) {
        ++counters_.other_version;
        return std::nullopt;
    }
    if (!entry || entry->digest != bytes::sha256(entry->content)) {
        ++counters_.damaged;
        return std::nullopt;
    }
    ++counters_.found;
    return std::move(entry->content);
}

bool Store::holds(const std::string& key) const {
    if (!enabled()) return false;
    const auto bytes = bytes_of(path_of(folder_, key));
    const auto entry = bytes ? parsed(*bytes) : std::nullopt;
    return entry && entry->version == version_ && entry->digest == bytes::sha256(entry->content);
}

void Store::keep(const std::string& key, std::string_view content) const {
    if (!enabled()) return;
    const auto path = path_of(folder_, key);
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    try {
        bytes::write_whole_file(path.string(), header(version_, content) + std::string(content));
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
        std::error_code ignored;
        content.bytes += file.file_size(ignored);
        if (!whole) return;
        ++content.entries;
        if (version_of(file.path()) != version_) ++content.of_other_versions;
    });
    return content;
}

Content Store::remove(bool of_other_versions_alone) const {
    Content removed;
    if (!enabled()) return removed;
    for_each_file(folder_, [&](const fs::directory_entry& file, bool whole) {
        const bool other = whole && version_of(file.path()) != version_;
        if (whole && of_other_versions_alone && !other) return;
        std::error_code failure;
        const auto size = file.file_size(failure);
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
