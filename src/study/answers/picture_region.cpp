// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/picture_region.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"

namespace setae::answers {

imaging::PictureRegion parse_region(const std::string& option, const std::string& text) {
    const auto region = spelled_list<long, 4>(text, ',');
    if (!region)
        throw InvalidArgument(
            fmt::format("{} {}: expected x,y,width,height in pixels, such as 100,80,320,240", option, text));
    return {(*region)[0], (*region)[1], (*region)[2], (*region)[3]};
}

}  // namespace setae::answers
