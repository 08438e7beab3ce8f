// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace setae::bytes {

/// The content of a file.
/// @throws FileError for a missing path, a directory or a file that cannot be read.
[[nodiscard]] std::string read_file(const std::string& path);

/// Replaces a file as a whole: written under a temporary name in the same folder, then renamed, so that a reader finds
/// the old content or the new one and never a part.
/// @throws FileError where the folder is missing or cannot be written; the old content is then untouched.
void write_whole_file(const std::string& path, std::string_view content);
/// The same for content in parts, one behind the other.
void write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts);
/// The same for a writer of its own, which is given the temporary name; what it throws passes on and nothing is
/// replaced.
void write_whole_file(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// Removes from a folder the temporary files of writers that are no more: processes of this machine that were killed.
void remove_leftovers(const std::string& folder);

}  // namespace setae::bytes
