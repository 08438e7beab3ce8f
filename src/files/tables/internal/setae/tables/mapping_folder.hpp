// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::tables {

/// Names of the mappings in a folder, their files without ".toml", in alphabetical order; none where there is no such
/// folder.
[[nodiscard]] std::vector<std::string> mapping_names(const std::string& folder);

/// The file of a mapping that is named by its path, or by its name in a folder of mappings.
/// @throws FileError that lists the folder's names where there is neither.
[[nodiscard]] std::string mapping_path(const std::string& name, const std::string& folder);

/// Names of the mappings in a folder through which a file reads as a loop.
[[nodiscard]] std::vector<std::string> fitting_mappings(const std::string& file, const std::string& folder);

/// "; a mapping that came with setae reads it: --mapping eoh" for the end of a message; empty where none does.
[[nodiscard]] std::string fitting_mappings_remark(const std::string& file, const std::string& folder);

}  // namespace setae::tables
