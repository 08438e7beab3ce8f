// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// A MarWin profile; positions and heights [mm], a flag where a height is NaN.
[[nodiscard]] std::string marwin_profile(const Array1D& positions, const Array1D& heights,
                                         const std::string& probe_radius);

}  // namespace setae::formats::tests
