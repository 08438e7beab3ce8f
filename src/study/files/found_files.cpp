// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "setae/study/file_content.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// Adds the files of a folder, then those of its folders.
void add_folder(const fs::path& folder, FoundFiles& found) {
    std::vector<fs::path> files, folders;
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
        if (entry->path().filename().string().starts_with('.')) continue;
        std::error_code unknown;
        if (entry->is_regular_file(unknown)) files.push_back(entry->path());
        else if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) folders.push_back(entry->path());
    }
    if (failure)
        found.unreadable.push_back(
            {folder.string(), fmt::format("{}: cannot list the folder ({})", folder.string(), failure.message())});
    std::sort(files.begin(), files.end());
    std::sort(folders.begin(), folders.end());
    for (const auto& file : files) found.files.push_back(file.string());
    for (const auto& inner : folders) add_folder(inner, found);
}

}  // namespace

FoundFiles found_files(const std::vector<std::string>& paths) {
    FoundFiles found;
    for (const auto& path : paths) {
        std::error_code unknown;
        if (!fs::is_directory(path, unknown)) {
            found.files.push_back(path);
            continue;
        }
        const auto files = found.files.size(), unreadable = found.unreadable.size();
        add_folder(path, found);
        if (found.files.size() == files && found.unreadable.size() == unreadable)
            found.unreadable.push_back(
                {path, fmt::format("{}: a folder without files; hidden files and linked folders are left out", path)});
    }
    return found;
}

}  // namespace setae::study
