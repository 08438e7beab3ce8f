// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace setae::output {

/// A part of a file's name for each name, no two alike, also where large and small letters are not told apart.
///
/// Letters of every language, digits, dash, dot and underscore stay, all else becomes an underscore; long names are cut
/// at 120 bytes. A name that needs none of that is kept; another that would be the same gets a number, "A_1_2".
[[nodiscard]] std::vector<std::string> file_names(std::span<const std::string> names);

}  // namespace setae::output
