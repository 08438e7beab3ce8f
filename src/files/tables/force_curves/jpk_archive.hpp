// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "setae/bytes/archive.hpp"
#include "setae/bytes/source.hpp"

namespace setae::tables {

using Properties = std::map<std::string, std::string>;

/// Content of an archive of JPK by its header: one force curve or a map of them.
enum class JpkKind { other, curve, map };

/// A ZIP archive of JPK: its headers, the folders of its segments; members are read from any thread.
class JpkArchive {
public:
    /// @throws FormatError for a damaged archive.
    explicit JpkArchive(const bytes::Source& source);

    [[nodiscard]] const bytes::Source& source() const { return source_; }
    [[nodiscard]] JpkKind kind() const;
    /// Folders of the segments of each curve, in order: "segments/N/" for a single curve, which has the number 0, and
    /// "index/NUMBER/segments/N/" for a map.
    [[nodiscard]] const std::map<long, std::vector<std::string>>& curves() const { return curves_; }
    [[nodiscard]] std::string read(const std::string& member) const;
    /// The properties of a member; empty if there is no such member.
    [[nodiscard]] Properties properties(const std::string& member) const;
    [[nodiscard]] const Properties& header() const { return header_; }  ///< of the file
    [[nodiscard]] const Properties& shared() const { return shared_; }  ///< properties that segments refer to

private:
    bytes::Source source_;
    bytes::Archive archive_;
    mutable std::mutex guard_;
    Properties header_, shared_;
    std::map<long, std::vector<std::string>> curves_;
};

/// The value of a key; empty if it is missing.
[[nodiscard]] std::optional<std::string> property(const Properties& properties, const std::string& key);

}  // namespace setae::tables
