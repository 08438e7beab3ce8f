// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/result_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "setae/bytes/folder_lock.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/study/own_outputs.hpp"

namespace setae::output {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = study::result_list;

/// Files whose existence marks complete results.
constexpr const char* marks[] = {"report.html", "study.json"};

/// Where a study has no path, its results are named by its title.
constexpr std::string_view by_title = "titled ";

/// Name of a study in the list: its path relative to the existing folder, so that both may be moved together. @throws
/// FileError where the path cannot be determined.
std::string identity_of(const study::Study& study, const std::string& folder) {
    if (study.path.empty()) return std::string(by_title) + one_line(study.title);
    std::error_code of_study, of_folder;
    const auto file = fs::weakly_canonical(study.path, of_study), from = fs::canonical(folder, of_folder);
    const auto seen = of_study || of_folder ? fs::path() : file.lexically_relative(from);
    if (seen.empty())
        throw FileError(
            fmt::format("{}: the path from this folder to the study {} cannot be determined", folder, study.path));
    return seen.generic_string();
}

/// @throws FileError where the list is that of a study that may still be there.
void require_same_study(const std::string& listed, const std::string& study, const std::string& folder) {
    if (listed == study) return;
    if (listed.empty())
        throw FileError(
            fmt::format("{}/{}: does not say whose results these are, expected a line '# study: …'; move "
                        "the folder away, or give the study another output",
                        folder, list_name));
    std::error_code ignored;
    const bool gone = !listed.starts_with(by_title) && !fs::exists(fs::path(folder) / listed, ignored);
    if (gone) return;
    throw FileError(fmt::format(
        "{}: holds the results of {}, expected a folder of this study's own or none; give it another output", folder,
        one_line(listed)));
}

/// Keeps other processes waiting, in the folder that the path leads to: another one may remove it before it is locked.
/// @throws FileError where it cannot be made.
std::unique_ptr<bytes::FolderLock> locked_folder(const std::string& folder, bool& made) {
    constexpr int max_tries = 100;
    std::unique_ptr<bytes::FolderLock> lock;
    for (int i = 0; i < max_tries && !(lock && lock->holds(folder)); ++i) {
        std::error_code failure;
        made = fs::create_directories(folder, failure) || made;
        if (failure)
            throw FileError(fmt::format("{}: cannot make the folder of the results ({})", folder, failure.message()));
        lock = std::make_unique<bytes::FolderLock>(folder);
    }
    return lock;
}

void protect_inputs(const study::Study& study) {
    bytes::protect_input(study.path);
    for (const auto& surface : study.surfaces)
        for (const auto& measurement : surface.measurements) bytes::protect_input(measurement.file);
    for (const auto& experiment : study.experiments) bytes::protect_input(experiment.file);
}

}  // namespace

ResultFolder::ResultFolder(const study::Study& study) : folder_(study.output.empty() ? "." : study.output) {
    protect_inputs(study);
    const auto folder_lock = locked_folder(folder_, made_);
    study_ = identity_of(study, folder_);
    std::error_code ignored;
    if (fs::exists(list_path(), ignored)) {
        auto list = study::read_result_list(list_path());
        require_same_study(list.study, study_, folder_);
        listed_ = std::move(list.names);
        if (list.study == study_) return;
    }
    bytes::write_whole_file(list_path(), study::as_text({study_, listed_}));
}

ResultFolder::~ResultFolder() {
    if (!listed_.empty()) return;
    std::error_code ignored;
    const bytes::FolderLock folder_lock(folder_);
    try {
        // another run of the same study may have written since
        if (study::read_result_list(list_path()) == study::ResultList{study_, {}}) fs::remove(list_path(), ignored);
    } catch (const std::exception&) {  // no list, nothing to remove
    }
    if (made_) fs::remove(folder_, ignored);  // where it is empty
}

std::string ResultFolder::list_path() const { return (fs::path(folder_) / list_name).string(); }

bool ResultFolder::holds(const std::string& name) const {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(fs::path(folder_) / name, ignored));
}

void ResultFolder::require_own_folder() const {
    std::error_code ignored;
    // a list that was removed during the run is made again
    if (!fs::exists(list_path(), ignored)) bytes::write_whole_file(list_path(), study::as_text({study_, listed_}));
    require_same_study(study::study_of_result_list(list_path()), study_, folder_);
}

bool ResultFolder::is_inside(const std::string& name) const {
    std::error_code ignored;
    const auto below = fs::weakly_canonical((fs::path(folder_) / name).parent_path(), ignored)
                           .lexically_relative(fs::weakly_canonical(folder_, ignored));
    return !below.empty() && *below.begin() != "..";
}

void ResultFolder::remove(const std::string& name) const {
    const auto path = fs::path(folder_) / name;
    std::error_code ignored;
    if (!is_inside(name) || !fs::is_regular_file(path, ignored)) return;
    bytes::require_no_input(path.string());
    fs::remove(path, ignored);
}

void ResultFolder::begin() const {
    const bytes::FolderLock folder_lock(folder_);
    require_own_folder();
    for (const char* mark : marks)
        if (listed_.contains(mark)) remove(mark);
    std::map<fs::path, std::set<std::string>> names;  // by subfolder
    for (const auto& name : listed_)
        if (is_inside(name)) names[fs::path(name).parent_path()].insert(fs::path(name).filename().string());
    names[{}].insert(list_name);
    for (const auto& [below, files] : names) bytes::remove_leftovers((fs::path(folder_) / below).string(), files);
}

std::string ResultFolder::claim(const std::string& name) {
    const auto path = (fs::path(folder_) / name).string();
    const std::lock_guard lock(mutex_);
    bytes::require_no_input(path);
    if (!is_inside(name))
        throw FileError(fmt::format("{}: its folder is a link that leads out of the results; remove the link", path));
    const bytes::FolderLock folder_lock(folder_);  // another process may be running the same study
    require_own_folder();
    if (!listed_.contains(name)) {
        if (holds(name) && !study::read_result_list(list_path()).names.contains(name))
            throw FileError(fmt::format(
                "{}: was not written by a run of this study ({} does not name it) and is kept; move it away, or give the "
                "study another output",
                path, list_name));
        std::ofstream list(list_path(), std::ios::app);
        list << study::result_list_line(name);
        list.close();
        if (!list) throw FileError(fmt::format("{}: cannot be written; check that it has space", list_path()));
        listed_.insert(name);
    }
    claimed_.insert(name);
    return path;
}

void ResultFolder::drop(const std::string& name) {
    const std::lock_guard lock(mutex_);
    claimed_.erase(name);
}

void ResultFolder::finish() {
    const std::lock_guard lock(mutex_);
    const bytes::FolderLock folder_lock(folder_);
    require_own_folder();
    auto names = study::read_result_list(list_path()).names;  // with those another process has claimed since
    for (const auto& name : listed_)
        if (!claimed_.contains(name)) {
            remove(name);
            names.erase(name);
        }
    names.insert(claimed_.begin(), claimed_.end());
    std::set<fs::path> below;
    for (const auto& name : listed_)
        if (auto parent = fs::path(name).parent_path(); !parent.empty()) below.insert(std::move(parent));
    std::error_code ignored;
    for (const auto& folder : below)
        if (fs::is_directory(fs::symlink_status(fs::path(folder_) / folder, ignored)))
            fs::remove(fs::path(folder_) / folder, ignored);  // where it is empty now
    bytes::write_whole_file(list_path(), study::as_text({study_, names}));
    listed_ = std::move(names);
}

}  // namespace setae::output
