// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Pages on the formats of topographies in Markdown by file name, made from the table of formats: README.md, the list
/// of all, and one page a format.
[[nodiscard]] std::map<std::string, std::string> format_pages();

}  // namespace setae::cli
