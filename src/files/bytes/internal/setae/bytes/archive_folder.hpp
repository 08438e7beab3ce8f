// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Whether a path is a regular file that begins as a ZIP archive, of any content.
[[nodiscard]] bool is_archive(const std::string& path);

/// The files of a ZIP archive as paths, "archive.zip/folder/member", sorted: files of a folder before its folders.
/// Hidden files and those added by macOS are left out. file_source() opens such paths.
/// @throws FormatError for a damaged archive, a member that leads out of it, and for more than 10 000 members.
[[nodiscard]] std::vector<std::string> files_of_archive(const std::string& path);

}  // namespace setae::bytes
