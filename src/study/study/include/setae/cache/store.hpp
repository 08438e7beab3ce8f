// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace setae::cache {

/// Counts of a store since it was opened.
struct Traffic {
    std::uint64_t found = 0;          ///< results taken from it
    std::uint64_t kept = 0;           ///< results put into it
    std::uint64_t damaged = 0;        ///< entries whose bytes differ from those that were written: computed again
    std::uint64_t other_version = 0;  ///< entries of another version of the program: computed again
    std::uint64_t not_kept = 0;       ///< results that could not be written
};

/// Content of a store.
struct Content {
    std::uint64_t entries = 0;
    std::uint64_t of_other_versions = 0;
    std::uintmax_t bytes = 0;
};

/// Results on disk, each under a key of all its inputs.
///
/// An entry is written to a temporary name and renamed, so that a process may end at any moment; it contains the
/// version that wrote it and the SHA-256 of its content, and is used only where both are right. Many threads and
/// processes may use one folder. A store never fails: results that cannot be read or written are computed, and counted.
class Store {
public:
    /// Keeps nothing and finds nothing.
    Store() = default;
    /// folder: made with the first entry.  version: version of the program that computed the results.
    Store(std::string folder, std::string version);

    [[nodiscard]] bool enabled() const { return !folder_.empty(); }
    [[nodiscard]] const std::string& folder() const { return folder_; }
    /// The content kept under a key, 64 hexadecimal digits as of KeyBuilder.
    [[nodiscard]] std::optional<std::string> find(const std::string& key) const;
    /// Whether find() would return a result, without counting it.
    [[nodiscard]] bool holds(const std::string& key) const;
    void keep(const std::string& key, std::string_view content) const;
    [[nodiscard]] Traffic traffic() const;
    [[nodiscard]] Content content() const;
    /// Removes every entry, or only those of other versions, and temporary files of interrupted writers. Returns the
    /// removed content.
    Content remove(bool only_other_versions = false) const;

private:
    std::string folder_, version_;
    struct Counters {
        std::atomic<std::uint64_t> found{0}, kept{0}, damaged{0}, other_version{0}, not_kept{0};
    };
    mutable Counters counters_;
};

/// Default folder of results: $SETAE_CACHE, else $XDG_CACHE_HOME/setae, else $HOME/.cache/setae; empty where none of
/// them is set.
[[nodiscard]] std::string default_folder();

}  // namespace setae::cache
