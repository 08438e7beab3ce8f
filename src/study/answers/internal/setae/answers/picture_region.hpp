// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/imaging/frames.hpp"

namespace setae::answers {

/// "100,80,320,240": x, y, width, height in pixels. @throws InvalidArgument that names the option.
[[nodiscard]] imaging::PictureRegion parse_region(const std::string& option, const std::string& text);

}  // namespace setae::answers
