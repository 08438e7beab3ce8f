// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::formats::tests {

/// Indices of one container in the keys of each generation; the members are "line.txt" and "map.nc".
[[nodiscard]] std::string old_yaml_index();
[[nodiscard]] std::string transitional_json_index();
[[nodiscard]] std::string json_index_text();
[[nodiscard]] std::string skeleton_json_index();

}  // namespace setae::formats::tests
