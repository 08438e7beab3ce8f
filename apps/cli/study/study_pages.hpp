// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Markdown pages of studies by file name, made from the tables of the program: study-keys.md, alerts.md, figures.md.
[[nodiscard]] std::map<std::string, std::string> study_pages();

}  // namespace setae::cli
