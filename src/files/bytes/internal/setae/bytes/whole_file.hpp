// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

namespace setae::bytes {

/// The content of a regular file, which is an input from now on: see ProtectedInputs.
/// @throws FileError for a missing path, what is no regular file and what cannot be read; never waits for a pipe.
[[nodiscard]] std::string read_file(const std::string& path);
/// The same for what this library wrote and may write again.
[[nodiscard]] std::string read_back(const std::string& path);

/// Replaces a file as a whole: written under a temporary name in the same folder, flushed to the disk, then renamed, so
/// that a reader finds the old content or the new one and never a part, after a power failure, too. What a symbolic
/// link leads to is replaced, the link stays; the new file has the permissions of the old one. The temporary name is
/// new and cannot be foreseen.
/// @throws FileError where the folder is missing or cannot be written, for protected inputs, and for what is no regular
/// file; the old content is then untouched.
void write_whole_file(const std::string& path, std::string_view content);
/// The same for content in parts, one behind the other.
void write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts);
/// Takes the next piece of a file's content.
using Write = std::function<void(std::string_view piece)>;
/// The same for content that is made piece by piece, which need never be in memory as a whole.
void write_whole_file(const std::string& path, const std::function<void(const Write& write)>& content);
/// The same for a writer of its own, which is given the temporary name; what it throws passes on and nothing is
/// replaced.
void write_whole_file(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// The same for content that can be made again: it is not flushed to the disk, and may be damaged after a power
/// failure.
void write_unflushed_file(const std::string& path, std::initializer_list<std::string_view> parts);

/// Removes from a folder the temporary files that were to become one of `names`, of writers that are no more: processes
/// of this machine that were killed.
void remove_leftovers(const std::string& folder, const std::set<std::string>& names);

}  // namespace setae::bytes
