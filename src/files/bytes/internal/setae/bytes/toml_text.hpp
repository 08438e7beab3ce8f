// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae::bytes {

/// A text as a basic string of TOML, in quotes on one line. Source: TOML 1.0, String.
[[nodiscard]] std::string toml_quoted(std::string_view text);

}  // namespace setae::bytes
