// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae::bytes {

/// A PNG that says which program made it, "Software: setae": figures and overlays are then no micrographs. Text that
/// does not begin as a PNG stays as it is. Source: PNG specification (third edition), 11.3.3.2.
[[nodiscard]] std::string with_png_mark(std::string png);

/// Whether the beginning of a file is that of a PNG with the mark.
[[nodiscard]] bool has_png_mark(std::string_view head);

}  // namespace setae::bytes
