// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "setae/core/arrays.hpp"

namespace setae {

/// A count or index >= 0 as size type of the standard library's containers.
[[nodiscard]] constexpr std::size_t extent(Index n) { return static_cast<std::size_t>(n); }

}  // namespace setae
