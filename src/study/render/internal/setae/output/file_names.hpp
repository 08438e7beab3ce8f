// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace setae::output {

/// A unique part of a file's name for each name, also without regard to case.
///
/// Letters of every language, digits, dash, dot and underscore stay, all else becomes an underscore; long names are cut
/// at 120 bytes. A name without such changes is kept; another one that would be equal gets a number, "A_1_2".
[[nodiscard]] std::vector<std::string> file_names(std::span<const std::string> names);

}  // namespace setae::output
