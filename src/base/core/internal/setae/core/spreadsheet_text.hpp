// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae {

/// A cell of a comma-separated table with this text: on one line, in double quotes if needed, after an apostrophe if a
/// spreadsheet would take it for a formula, that is if it begins (blanks ignored) with = + - @ or their full-width
/// forms. Every text written to such a table passes through this function.
/// Source: RFC 4180; OWASP, CSV injection.
[[nodiscard]] std::string spreadsheet_cell(std::string_view text);

}  // namespace setae
