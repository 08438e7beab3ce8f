// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// A member of an archive to be written. Its bytes are requested when they are written, one member at a time.
struct ArchiveMember {
    std::string name;
    std::function<Source()> content;
};

/// Writes a ZIP archive with a temporary name in the same folder, then renames it. Members are stored in order without
/// compression, with the time 1980-01-01: the same input gives the same bytes, regardless of the compression library.
/// @throws FileError if it cannot be written; InvalidArgument for two members with one name or a name that leads out of
/// the archive; exceptions of a member's content. The old file is then unchanged.
void write_archive(const std::string& path, const std::vector<ArchiveMember>& members);

}  // namespace setae::bytes
