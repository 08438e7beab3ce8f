// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace setae::figures {

/// Whether an installed font has a character, given as UTF-8: gnuplot's cairo terminals draw a missing one as a black
/// shape larger than the figure. Determined by fontconfig's fc-list; without it, by the characters of European fonts.
[[nodiscard]] bool is_drawn(std::string_view character);

}  // namespace setae::figures
