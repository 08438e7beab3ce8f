// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/output/json.hpp"

namespace setae::report {

/// Text as HTML shows it letter by letter, in elements and in quoted attributes; control characters as blanks, bytes
/// that are no UTF-8 as U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// Sentences of warnings and captions as HTML: 5e-06 is 5×10⁻⁶, W_int, U_el and similar are set as symbols, mJ/m2 as mJ
/// m⁻². All else is plain text.
[[nodiscard]] std::string prose(std::string_view text);

/// JSON for an element <script type="application/json">: no text in it can end the element.
[[nodiscard]] std::string script_json(const output::Json& json);

/// Markup of figures::Axis::quantity as HTML (<i>, <sub>, <sup>) and as plain text.
[[nodiscard]] std::string typeset(std::string_view quantity);
[[nodiscard]] std::string plain(std::string_view quantity);

/// An exponent, raised: −22 is "⁻²²".
[[nodiscard]] std::string raised(std::string_view digits);

/// A unit as setae spells it, "mJ/m2", as a reader expects it, "mJ m⁻²"; "1" is empty.
[[nodiscard]] std::string typeset_unit(std::string_view unit);

}  // namespace setae::report
