// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::tables {

/// Names of the mappings in a folder, their files without ".toml", in alphabetical order; none if there is no such
/// folder.
[[nodiscard]] std::vector<std::string> mapping_names(const std::string& folder);

/// The file of a mapping given by its path, or by its name in a folder of mappings.
/// @throws FileError that lists the names in the folder if there is neither.
[[nodiscard]] std::string mapping_path(const std::string& name, const std::string& folder);

/// Names of the mappings in a folder with which a file can be read as a loop.
[[nodiscard]] std::vector<std::string> fitting_mappings(const std::string& file, const std::string& folder);

/// "; a mapping that came with setae reads it: --mapping eoh" for the end of a message; empty if none does.
[[nodiscard]] std::string fitting_mappings_hint(const std::string& file, const std::string& folder);

}  // namespace setae::tables
