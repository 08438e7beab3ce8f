// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The ZIP archive after a picture of `picture_bytes` bytes at `picture`, the layout of Keyence files.
/// @throws FormatError "<format>: …" if no archive begins there or within the next KiB.
[[nodiscard]] bytes::Source archive_after_picture(const bytes::Source& source, std::uint64_t picture,
                                                  std::uint64_t picture_bytes, const std::string& format);

using OpenFile = std::function<std::vector<Channel>(const bytes::Source&, const ReadOptions&)>;

/// The channels of a member that is a file, with the format of the archive. The member is not kept in memory: reading
/// heights opens it again. A member that cannot be read becomes a channel with the warning UNREADABLE_MEMBER, whose
/// `read` throws the reason.
[[nodiscard]] std::vector<Channel> member_channels(const bytes::Source& archive, const std::string& member,
                                                   const std::string& title, const std::string& format,
                                                   const OpenFile& open_file, const ReadOptions& options);

}  // namespace setae::formats
