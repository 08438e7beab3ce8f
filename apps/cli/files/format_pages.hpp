// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Markdown pages of the formats of topographies by file name, made from the table of formats: README.md with the
/// list of formats, and one page per format.
[[nodiscard]] std::map<std::string, std::string> format_pages();

}  // namespace setae::cli
