// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae::bytes {

/// Adds "Software: setae" to a PNG: figures and overlays of setae are then not read as micrographs. Text that does not
/// begin as a PNG is unchanged. Source: PNG specification (third edition), 11.3.3.2.
[[nodiscard]] std::string with_png_mark(std::string png);

/// Whether the beginning of a file is that of a PNG with the mark.
[[nodiscard]] bool has_png_mark(std::string_view head);

}  // namespace setae::bytes
