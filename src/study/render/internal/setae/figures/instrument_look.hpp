// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace setae::figures {

/// Appearance of an instrument in every figure.
struct InstrumentLook {
    int colour = 0;  ///< index into the palette
    int symbol = 0;  ///< symbol and dash
};

/// The appearance of a type of instruments, in capitals or not: "stylus"; "afm"; "tem"; "optical", "confocal" and
/// "interferometer" equally; grey for all others.
[[nodiscard]] InstrumentLook instrument_look(std::string_view type);

}  // namespace setae::figures
