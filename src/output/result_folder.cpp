// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/result_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

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
constexpr std::string_view heading = study::result_list_heading;
constexpr std::string_view study_mark = "# study: ";

/// What says, where it exists, that all results do.
constexpr const char* marks[] = {"report.html", "study.json"};

/// How the list names a study: its path as seen from the folder, so that both may be moved together; by its title where
/// it has no path.
std::string identity_of(const study::Study& study, const std::string& folder) {
    if (study.path.empty()) return "titled " + one_line(study.title);
    std::error_code ignored;
    const auto file = fs::weakly_canonical(study.path, ignored),
               from = fs::weakly_canonical(folder.empty() ? "." : folder, ignored);
    return file.lexically_relative(from).generic_string();
}

/// A name a list may hold: inside the folder, by its letters.
bool stays_inside(const std::string& name) {
    const fs::path path(name);
    return !name.empty() && path.is_relative() && path == path.lexically_normal() && *path.begin() != ".." &&
           *path.begin() != "." && name.back() != '/';
}

struct FileList {
    std::string study;
    std::set<std::string> names;
};

FileList read_list(const std::string& path) {
    FileList list;
    std::istringstream lines(bytes::read_back(path));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(study_mark)) list.study = line.substr(study_mark.size());
        else if (!line.starts_with('#') && stays_inside(line)) list.names.insert(line);
    }
    return list;
}

std::string list_text(const std::string& study, const std::set<std::string>& names) {
    auto text = std::string(heading) + std::string(study_mark) + study + "\n";
    for (const auto& name : names) text += name + "\n";
    return text;
}

/// @throws FileError where the list is that of a study whose file is still there.
void require_same_study(const FileList& list, const std::string& study, const std::string& folder) {
    if (list.study.empty() || list.study == study) return;
    std::error_code ignored;
    if (!fs::exists(fs::path(folder) / list.study, ignored)) return;
    throw FileError(fmt::format(
        "{}: holds the results of {}, expected a folder of this study's own or none; give it another output", folder,
        list.study));
}

void protect_inputs(const study::Study& study) {
    bytes::protect_input(study.path);
    for (const auto& surface : study.surfaces)
        for (const auto& measurement : surface.measurements) bytes::protect_input(measurement.file);
    for (const auto& experiment : study.experiments) bytes::protect_input(experiment.file);
}

}  // namespace

ResultFolder::ResultFolder(const study::Study& study)
    : folder_(study.output), study_(identity_of(study, study.output)) {
    std::error_code failure;
    made_ = fs::create_directories(folder_, failure);
    if (failure)
        throw FileError(fmt::format("{}: cannot make the folder of the results ({})", folder_, failure.message()));
    protect_inputs(study);
    const bytes::FolderLock alone(folder_);
    const auto list_path = (fs::path(folder_) / list_name).string();
    if (!fs::exists(list_path, failure)) return;
    auto list = read_list(list_path);
    require_same_study(list, study_, folder_);
    listed_ = std::move(list.names);
}

ResultFolder::~ResultFolder() {
    std::error_code not_empty;
    if (made_) fs::remove(folder_, not_empty);
}

bool ResultFolder::holds(const std::string& name) const {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(fs::path(folder_) / name, ignored));
}

std::set<std::string> ResultFolder::names_on_disk() const {
    const auto path = fs::path(folder_) / list_name;
    std::error_code ignored;
    return fs::exists(path, ignored) ? read_list(path.string()).names : std::set<std::string>();
}

void ResultFolder::remove(const std::string& name) const {
    const auto path = fs::path(folder_) / name;
    std::error_code ignored;
    // a folder below that leads elsewhere holds nothing of ours
    const auto inside = fs::weakly_canonical(path.parent_path(), ignored)
                            .lexically_relative(fs::weakly_canonical(folder_.empty() ? "." : folder_, ignored));
    if (inside.empty() || *inside.begin() == ".." || !fs::is_regular_file(path, ignored)) return;
    bytes::require_no_input(path.string());
    fs::remove(path, ignored);
}

void ResultFolder::begin() const {
    for (const char* mark : marks)
        if (listed_.contains(mark)) remove(mark);
    bytes::remove_leftovers(folder_);
    bytes::remove_leftovers((fs::path(folder_) / "figures").string());
}

std::string ResultFolder::claim(const std::string& name) {
    const auto path = (fs::path(folder_) / name).string();
    const std::lock_guard lock(mutex_);
    bytes::require_no_input(path);
    if (!listed_.contains(name)) {
        const bytes::FolderLock alone(folder_);  // another process may be running the same study
        if (holds(name) && !names_on_disk().contains(name))
            throw FileError(fmt::format(
                "{}: was not written by a run of this study ({} does not name it) and is kept; move it away, or give the "
                "study another output",
                path, list_name));
        const auto list_path = fs::path(folder_) / list_name;
        std::error_code ignored;
        if (!fs::exists(list_path, ignored)) bytes::write_whole_file(list_path.string(), list_text(study_, {}));
        std::ofstream list(list_path, std::ios::app);
        list << name << '\n';
        list.close();
        if (!list) throw FileError(fmt::format("{}: cannot be written; check that it has space", list_path.string()));
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
    const bytes::FolderLock alone(folder_);
    auto names = names_on_disk();  // with those another process has claimed since
    for (const auto& name : listed_)
        if (!claimed_.contains(name)) {
            remove(name);
            names.erase(name);
        }
    names.insert(claimed_.begin(), claimed_.end());
    std::error_code ignored;
    for (const auto& name : listed_)
        if (const auto below = fs::path(name).parent_path(); !below.empty())
            fs::remove(fs::path(folder_) / below, ignored);  // where it is empty now
    bytes::write_whole_file((fs::path(folder_) / list_name).string(), list_text(study_, names));
    listed_ = std::move(names);
}

}  // namespace setae::output
