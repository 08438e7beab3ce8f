// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "setae/bytes/archive.hpp"
#include "setae/bytes/archive_folder.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/study/file_content.hpp"
#include "setae/study/own_outputs.hpp"
#include "setae/tables/force_curve.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// A ZIP archive that no reader recognises: not a container, a workbook, an instrument's file.
bool is_plain_archive(const std::string& path) {
    if (!bytes::is_archive(path)) return false;
    try {
        const auto source = bytes::file_source(path);
        if (tables::force_curve_format(source)) return false;
        (void)bytes::Archive(source);
        try {
            (void)formats::detect_format(source);
            return false;
        } catch (const FormatError&) {
            return true;
        }
    } catch (const Error&) {  // damaged: opening it later reports the reason
        return false;
    }
}

void add_archive(const std::string& path, FoundFiles& found) {
    try {
        const auto files = bytes::files_of_archive(path);
        for (const auto& file : files) (is_own_output(file) ? found.own : found.files).push_back(file);
    } catch (const Error& error) {
        found.unreadable.push_back({path, error.what()});
    }
}

/// Adds the files of a folder, then those of its folders; `results`: files of studies' results.
void add_folder(const fs::path& folder, FoundFiles& found, std::set<std::string> results) {
    results.merge(results_in(folder.string()));
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
    for (const auto& file : files)
        if (results.contains(file.string()) || is_own_output(file.string())) found.own.push_back(file.string());
        else if (is_plain_archive(file.string())) add_archive(file.string(), found);
        else found.files.push_back(file.string());
    for (const auto& inner : folders) add_folder(inner, found, results);
}

}  // namespace

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown) || is_plain_archive(path);
}

FoundFiles found_files(const std::vector<std::string>& paths) {
    FoundFiles found;
    for (const auto& path : paths) {
        std::error_code unknown;
        const auto files = found.files.size(), unreadable = found.unreadable.size(), own = found.own.size();
        if (fs::is_directory(path, unknown)) add_folder(path, found, {});
        else if (is_plain_archive(path)) add_archive(path, found);
        else {
            found.files.push_back(path);
            continue;
        }
        if (found.files.size() == files && found.unreadable.size() == unreadable)
            found.unreadable.push_back(
                {path,
                 found.own.size() > own
                     ? fmt::format("{}: the folder contains only files that setae wrote; name its files to read them",
                                   path)
                     : fmt::format("{}: the folder contains no files; hidden files and linked folders are left out",
                                   path)});
    }
    return found;
}

}  // namespace setae::study
