// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace setae {

/// "no pairs", "1 pair", "3 pairs".
[[nodiscard]] std::string counted(std::size_t n, const std::string& one, const std::string& many);

/// "A, B and C"; for more than six names the first five and the number of the others.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace setae
