// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/terminal.hpp"

#include <algorithm>

#include "setae/platform/terminal.hpp"

namespace setae::cli {
output::Screen output_size() {
    output::Screen size;
    if (const auto columns = platform::columns_of(platform::Stream::output); columns > 0)
        size.width = std::clamp<std::size_t>(columns, 60, 120);
    return size;
}

std::size_t columns_of_errors() {
    const auto columns = platform::columns_of(platform::Stream::errors);
    return columns > 0 ? columns : 80;
}

}  // namespace setae::cli
