// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// A member of an archive to be written. Its bytes are asked for when they are written, one member at a time.
struct ArchiveMember {
    std::string name;
    std::function<Source()> content;
};

/// Writes a ZIP archive, under another name in the same folder, then renamed. Members are stored in order and not
/// compressed, their time is 1980-01-01: the same input gives the same bytes, whatever library compresses.
/// @throws FileError where it cannot be written; InvalidArgument for two members of one name or a name that leads out
/// of the archive; what a member's content throws: the old file is then untouched.
void write_archive(const std::string& path, const std::vector<ArchiveMember>& members);

}  // namespace setae::bytes
