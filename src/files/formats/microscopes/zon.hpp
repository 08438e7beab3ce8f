// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/bytes/archive.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The archive of a ZON or ZAG file, after its picture. @throws FormatError for other files.
[[nodiscard]] bytes::Source keyence_archive(const bytes::Source& source);

/// Content of a member, expanded if it is additionally compressed by Zstandard.
[[nodiscard]] std::string keyence_member(const bytes::Archive& archive, const std::string& name,
                                         const bytes::Source& source);

/// Whether bytes begin as a ZON or ZAG file, a condition of keyence_archive.
[[nodiscard]] bool is_keyence_package(std::string_view head);

[[nodiscard]] std::vector<Channel> open_zon(const bytes::Source& source, const ReadOptions& options);

}  // namespace setae::formats
