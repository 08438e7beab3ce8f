// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae {

/// A cell of a table of commas that holds this text: on one line, in double quotes where it needs them, behind an
/// apostrophe where a spreadsheet would take it for a formula, that is where it begins, blanks apart, with = + - @ or
/// their full-width forms. Every text that leaves in such a table goes through here.
/// Source: RFC 4180; OWASP, CSV injection.
[[nodiscard]] std::string spreadsheet_cell(std::string_view text);

}  // namespace setae
