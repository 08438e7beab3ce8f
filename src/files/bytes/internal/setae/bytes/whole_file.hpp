// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

namespace setae::bytes {

/// The content of a regular file, which is registered as input: see ProtectedInputs.
/// @throws FileError for a missing path, for anything but a regular file and for a file that cannot be read; never
/// waits for a pipe.
[[nodiscard]] std::string read_file(const std::string& path);
/// The content of a file that this library wrote and may overwrite.
[[nodiscard]] std::string read_back(const std::string& path);

/// Replaces a file as a whole: written with a temporary name in the same folder, flushed to the disk, then renamed. A
/// reader finds the old or the new content and never a part, also after a power failure. The target of a symbolic link
/// is replaced, the link remains; the new file has the permissions of the old one. The temporary name is new and
/// unpredictable.
/// @throws FileError if the folder is missing or cannot be written, for protected inputs, and for anything but a
/// regular file; the old content is then unchanged.
void write_whole_file(const std::string& path, std::string_view content);
/// write_whole_file() for content in parts, in sequence.
void write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts);
/// Takes the next piece of a file's content.
using Write = std::function<void(std::string_view piece)>;
/// write_whole_file() for content that is produced piece by piece and is never in memory as a whole.
void write_whole_file(const std::string& path, const std::function<void(const Write& write)>& content);
/// write_whole_file() with a function that writes to the given temporary name; its exceptions are passed on and nothing
/// is replaced.
void write_whole_file(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// write_whole_file() for content that can be reproduced: it is not flushed to the disk, and may be damaged after a
/// power failure.
void write_unflushed_file(const std::string& path, std::initializer_list<std::string_view> parts);

/// Removes temporary files of `names` in a folder that were left by killed processes of this computer.
void remove_leftovers(const std::string& folder, const std::set<std::string>& names);

}  // namespace setae::bytes
