// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/answers/contents.hpp"

namespace setae::cli::info_command {

using answers::can_be_read;
using answers::ListedChannel;
using answers::ListedFile;

/// Amount of detail per file. Each level contains the columns of the level before.
enum class Detail { little, usual, all };

/// Files as tables for a terminal of a width: one table per kind, headed by the commands that accept its files. Paths
/// are relative to the folder that contains all files, which is printed first. In a table that is too wide, names of
/// files are shortened as long as they differ, then columns are left out, then rows are stacked.
[[nodiscard]] std::string file_tables(const std::vector<ListedFile>& files, Detail detail, std::size_t width);

}  // namespace setae::cli::info_command
