// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/tables/nanoscope_header.hpp"

namespace setae::formats {

/// Whether a channel of a scanning probe contains heights of the surface: its unit is a length, and its name is none of
/// the other quantities with a unit of length: amplitudes, deflections, errors of the feedback, deformations …
[[nodiscard]] bool holds_heights(std::string_view name, std::string_view unit);

using tables::plain_unit;

}  // namespace setae::formats
