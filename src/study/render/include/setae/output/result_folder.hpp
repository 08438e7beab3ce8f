// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <set>
#include <string>

#include "setae/study/study.hpp"

namespace setae::output {

/// The folder of a study's results. The list in files.txt contains the files that runs of this study wrote into it: a
/// run replaces and removes only those.
///
/// The list names the study before any computation, and is checked before each file is written: of two studies that
/// start at once, one is refused. The list is extended before each file is written, so that it is complete even after a
/// run was killed. Threads may claim files at the same time.
class ResultFolder {
public:
    /// Makes the folder where missing, and protects every file the study reads. @throws FileError where it cannot be
    /// made, contains the results of another existing study, or a list that names no study.
    explicit ResultFolder(const study::Study& study);
    /// Removes the list, and a folder that it made, if no other file was written.
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return folder_; }

    /// Removes the marks of complete results, and temporary files of killed writers.
    void begin() const;

    /// Path of a file called `name`, "surfaces.csv" or "figures/figure_1.svg".
    /// @throws FileError for an input, for a file that no run of this study wrote, for a subfolder that is a link to
    /// another folder, and where another study has taken the folder.
    [[nodiscard]] std::string claim(const std::string& name);

    /// A file that was claimed and could not be written.
    void drop(const std::string& name);

    /// Removes the files of earlier runs that this one did not claim, and writes the list.
    void finish();

private:
    [[nodiscard]] std::string list_path() const;
    [[nodiscard]] bool holds(const std::string& name) const;
    /// Whether no link leads a file below out of the folder.
    [[nodiscard]] bool is_inside(const std::string& name) const;
    /// @throws FileError where another study has taken the folder since.
    void require_own_folder() const;
    void remove(const std::string& name) const;

    std::string folder_, study_;
    bool made_ = false;
    std::set<std::string> listed_, claimed_;
    std::mutex mutex_;
};

}  // namespace setae::output
