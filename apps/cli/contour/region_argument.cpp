// SPDX-License-Identifier: GPL-3.0-or-later
#include "contour/region_argument.hpp"

#include <charconv>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::cli {

imaging::Region parse_region(const std::string& option, const std::string& text) {
    imaging::Region region;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (long* part : {&region.x, &region.y, &region.width, &region.height}) {
        const auto [after, error] = std::from_chars(at, end, *part);
        const bool last = part == &region.height;
        if (error != std::errc() || (last ? after != end : after == end || *after != ','))
            throw InvalidArgument(
                fmt::format("{} {}: expected x,y,width,height in pixels, such as 100,80,320,240", option, text));
        at = last ? after : after + 1;
    }
    return region;
}

}  // namespace setae::cli
