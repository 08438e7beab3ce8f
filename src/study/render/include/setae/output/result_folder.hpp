// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <set>
#include <string>

#include "setae/study/study.hpp"

namespace setae::output {

/// The folder of a study's results. It knows which files runs of this study wrote into it, by the list in files.txt: a
/// run replaces and removes those alone.
///
/// The list says whose results they are before anything is computed, and is looked at before each file is written: of
/// two studies that begin at once, one is refused. It grows before each file is written, so that it names every one of
/// a run that was killed, too. Threads may claim files at the same time.
class ResultFolder {
public:
    /// Makes the folder where missing, and protects every file the study reads. @throws FileError where it cannot be
    /// made, holds the results of a study that is still there and is not this one, or a list that names no study.
    explicit ResultFolder(const study::Study& study);
    /// Removes the list, and a folder that it made, where nothing else was written.
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return folder_; }

    /// Removes what says that results are complete, until they are again, and what writers that were killed left.
    void begin() const;

    /// Where a file called `name`, "surfaces.csv" or "figures/figure_1.svg", is to be written.
    /// @throws FileError for an input, for a file that no run of this study wrote, for a folder below that is a link
    /// elsewhere, and where another study has taken the folder.
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
