// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace setae::formats {

/// Words of a name in lower case: letters and digits separated by other characters, and where a lower-case letter is
/// followed by a capital.
[[nodiscard]] std::vector<std::string> words_of_name(std::string_view name);

/// Whether a name indicates heights of a surface: one of its words is height, heights, topography, topo, elevation or
/// surface, or the whole name, the last part of a path, is z or h.
[[nodiscard]] bool is_height_name(std::string_view name);

}  // namespace setae::formats
