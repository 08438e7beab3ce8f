// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"

namespace setae::answers {

/// Pressures [Pa] of a text: "10 MPa", several "1MPa,10MPa", or ten per decade from the first to the last,
/// "1MPa:100MPa". @throws InvalidArgument for a text that is none of these; ends of a range that are not positive and
/// increasing.
[[nodiscard]] Array1D pressures_of(const std::string& text);

}  // namespace setae::answers
