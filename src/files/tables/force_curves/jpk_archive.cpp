// SPDX-License-Identifier: GPL-3.0-or-later
#include "jpk_archive.hpp"

#include <set>
#include <string_view>

#include "setae/bytes/text.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {
namespace {

constexpr const char* file_header = "header.properties";
constexpr const char* shared_header = "shared-data/header.properties";

/// Text of a Java properties file without its escapes.
std::string unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        result += text[i];
    }
    return result;
}

Properties parse_properties(const std::string& text) {
    Properties properties;
    for (auto line : bytes::split_lines(text)) {
        line = trimmed(line);
        const auto equal = line.find('=');
        if (line.empty() || line.front() == '#' || line.front() == '!' || equal == std::string_view::npos) continue;
        properties.insert_or_assign(unescaped(trimmed(line.substr(0, equal))),
                                    unescaped(trimmed(line.substr(equal + 1))));
    }
    return properties;
}

/// Removes "NAME/NUMBER/" from the beginning of a path.
std::optional<long> numbered_folder(std::string_view& path, std::string_view name) {
    if (!path.starts_with(name)) return std::nullopt;
    const auto rest = path.substr(name.size());
    const auto slash = rest.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto number = spelled<long>(rest.substr(0, slash));
    if (number) path = rest.substr(slash + 1);
    return number;
}

/// Folders with a header of a segment, by curve.
std::map<long, std::vector<std::string>> segment_folders(const bytes::Archive& archive) {
    constexpr std::string_view header = "segment-header.properties";
    std::map<long, std::map<long, std::string>> found;
    for (const auto& name : archive.names()) {
        if (!name.ends_with(header)) continue;
        std::string_view path = name;
        const auto curve = numbered_folder(path, "index/");
        const auto segment = numbered_folder(path, "segments/");
        if (segment && path == header)
            found[curve.value_or(0)].emplace(*segment, name.substr(0, name.size() - header.size()));
    }
    std::map<long, std::vector<std::string>> folders;
    for (const auto& [curve, segments] : found)
        for (const auto& [number, folder] : segments) folders[curve].push_back(folder);
    return folders;
}

}  // namespace

std::optional<std::string> property(const Properties& properties, const std::string& key) {
    const auto found = properties.find(key);
    return found == properties.end() ? std::nullopt : std::optional(found->second);
}

JpkArchive::JpkArchive(const bytes::Source& source)
    : source_(source), archive_(source), curves_(segment_folders(archive_)) {
    header_ = properties(file_header);
    shared_ = properties(shared_header);
}

JpkKind JpkArchive::kind() const {
    static const std::set<std::string> curve{"spm-forcefile", "spm-quantitative-image-series-file", "force-scan-series",
                                             "quantitative-imaging-series"},
        map{"spm-force-scan-map-file", "spm-quantitative-image-data-file", "force-scan-map",
            "quantitative-imaging-map"};
    if (curves_.empty()) return JpkKind::other;
    // files rewritten by other programs contain only their type
    for (const char* key : {"jpk-data-file", "type"}) {
        const auto kind = property(header_, key);
        if (kind && curve.contains(*kind)) return JpkKind::curve;
        if (kind && map.contains(*kind)) return JpkKind::map;
    }
    return JpkKind::other;
}

std::string JpkArchive::read(const std::string& member) const {
    const std::lock_guard lock(guard_);
    return archive_.read(member);
}

Properties JpkArchive::properties(const std::string& member) const {
    const std::lock_guard lock(guard_);
    return archive_.has(member) ? parse_properties(archive_.read(member)) : Properties{};
}

}  // namespace setae::tables
