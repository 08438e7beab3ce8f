// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/archive_folder.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "setae/bytes/archive.hpp"
#include "setae/core/errors.hpp"
#include "setae/platform/files.hpp"

namespace setae::bytes {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_members = 10'000;

bool is_hidden(const fs::path& member) {
    return std::any_of(member.begin(), member.end(), [](const fs::path& part) {
        const auto name = part.string();
        return name.starts_with('.') || name == "__MACOSX";
    });
}

/// Files of a folder go before its folders, each by name.
bool before(const fs::path& a, const fs::path& b) {
    const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (x == a.end() || y == b.end()) return x == a.end() && y != b.end();
    const bool file_a = std::next(x) == a.end(), file_b = std::next(y) == b.end();
    return file_a != file_b ? file_a : *x < *y;
}

}  // namespace

bool is_archive(const std::string& path) {
    const platform::ReadableFile file(path);
    const auto& facts = file.facts();
    char head[4];
    return facts && facts->kind == platform::FileKind::regular && !file.failure() && facts->size >= sizeof head &&
           file.read(0, sizeof head, head) && is_zip({head, sizeof head});
}

std::vector<std::string> files_of_archive(const std::string& path) {
    const auto names = Archive(file_source(path)).names();
    if (names.size() > max_members)
        throw FormatError(
            path, {},
            fmt::format("an archive of {} members; a folder may have at most {}; unpack the archive first",
                        names.size(), max_members));
    std::vector<fs::path> members;
    for (const auto& name : names)
        if (!name.empty() && !name.ends_with('/') && !is_hidden(name)) members.emplace_back(name);
    std::sort(members.begin(), members.end(), before);
    std::vector<std::string> paths;
    for (const auto& member : members) paths.push_back(path + "/" + member.generic_string());
    return paths;
}

}  // namespace setae::bytes
