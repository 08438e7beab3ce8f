// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/io/channel.hpp"
#include "setae/io/format.hpp"
#include "setae/io/source.hpp"

namespace setae::io {

/// Both kinds of images of JPK Instruments: scanned line by line, or made of the force curve of each pixel.
enum class JpkImage { scan, force_curves };

[[nodiscard]] Match detect_jpk_image(std::string_view head, const Source& source, JpkImage kind);

/// The channels of such an image. @throws FormatError.
[[nodiscard]] std::vector<Channel> open_jpk_image(const Source& source, const std::string& format);

}  // namespace setae::io
