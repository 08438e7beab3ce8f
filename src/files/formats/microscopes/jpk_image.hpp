// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"

namespace setae::formats {

/// Both kinds of images of JPK Instruments: scanned line by line, or composed of the force curves of the pixels.
enum class JpkImage { scan, force_curves };

[[nodiscard]] Match detect_jpk_image(std::string_view head, const bytes::Source& source, JpkImage kind);

/// The channels of such an image. @throws FormatError.
[[nodiscard]] std::vector<Channel> open_jpk_image(const bytes::Source& source, const std::string& format,
                                                  const ReadOptions& options);

}  // namespace setae::formats
