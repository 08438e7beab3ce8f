// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Names of directions in pipeline files.
inline constexpr std::array<Choice<Direction>, 2> direction_names{{{"x", Direction::x}, {"y", Direction::y}}};

}  // namespace setae::processing
