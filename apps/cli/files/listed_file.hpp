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

/// How much is said of each file. What is left out where little is said is there with more.
enum class Detail { little, usual, all };

/// Files as tables for a terminal of a width: one for each kind, headed by the commands that take such files. Paths
/// are relative to the folder that holds them all, which is named first. Where a table is too wide, names of files give
/// way as long as they can be told, then little is said; at last rows are stacked.
[[nodiscard]] std::string file_tables(const std::vector<ListedFile>& files, Detail detail, std::size_t width);

}  // namespace setae::cli::info_command
