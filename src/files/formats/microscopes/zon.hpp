// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/bytes/archive.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The archive of a ZON or ZAG file, behind its picture. @throws FormatError where the file is none.
[[nodiscard]] bytes::Source keyence_archive(const bytes::Source& source);

/// A member's content, expanded where it is packed once more by Zstandard.
[[nodiscard]] std::string keyence_member(const bytes::Archive& archive, const std::string& name,
                                         const bytes::Source& source);

/// Whether bytes begin as a ZON or ZAG file, and so whether keyence_archive may be asked.
[[nodiscard]] bool is_keyence_package(std::string_view head);

[[nodiscard]] std::vector<Channel> open_zon(const bytes::Source& source, const ReadOptions& options);

}  // namespace setae::formats
