// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// A scan with the channels Z [m], both directions, and Current [A], forward; `z` as displayed, first y at the top.
[[nodiscard]] std::string nanonis_file(const Array2D& z, const std::string& direction, const std::string& range,
                                       const std::string& type = "FLOAT            MSBFIRST");

}  // namespace setae::formats::tests
