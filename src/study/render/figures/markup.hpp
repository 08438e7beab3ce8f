// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae::figures {

/// Text for gnuplot that it shows letter by letter: in single quotes, the signs of its markup escaped, control
/// characters and bytes that are no UTF-8 as blanks.
[[nodiscard]] std::string quoted_verbatim(std::string_view text);

/// As quoted_verbatim: a bold letter and words after it; only words are bold.
[[nodiscard]] std::string quoted_heading(std::string_view letter, std::string_view words);

/// As quoted_verbatim, for a tick, whose text gnuplot also takes for a number's format.
[[nodiscard]] std::string quoted_tick(std::string_view text);

/// An axis' quantity (markup as Axis::quantity) with its unit in parentheses, quoted.
[[nodiscard]] std::string quoted_axis_title(std::string_view quantity, std::string_view unit);

}  // namespace setae::figures
