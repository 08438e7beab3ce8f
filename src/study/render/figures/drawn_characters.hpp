// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace setae::figures {

/// Whether a font of this machine has a character, given as UTF-8: gnuplot's cairo terminals draw one that none has as
/// a black shape larger than the figure. Asked of fontconfig's fc-list; without it, what European fonts have is taken
/// for drawn.
[[nodiscard]] bool is_drawn(std::string_view character);

}  // namespace setae::figures
