// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/study/file_content.hpp"

namespace setae::study {

/// A study's file in the making.
struct StudyDraft {
    std::string text;  ///< TOML that read_study() reads without changes
    std::size_t surfaces = 0, measurements = 0, loops = 0, micrographs = 0;
    std::vector<UnreadablePath> left_out;  ///< files that are nothing a study names
    std::vector<std::string> own;          ///< files of the folders that setae wrote: figures, tables, reports
};

/// Drafts the study of files and folders: surfaces from their measurements, grouped by folder, with instrument and tip
/// from the files, and for all missing values a commented line `# KEY = "?"`. Loops become experiments in comments, as
/// elastomers and the rough solid need values that no file contains; micrographs are listed with the command that makes
/// profiles of them. Folders named after an instrument belong to the folder around them. Results of studies are left
/// out. Paths are relative to the folder of `study_file`, which need not exist. A loop with unknown columns gets the
/// mapping of `mapping_folder` that reads it.
///
/// Equal files give equal text.
[[nodiscard]] StudyDraft draft_study(const std::vector<std::string>& paths, const std::string& study_file,
                                     const std::string& mapping_folder = {});

}  // namespace setae::study
