// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Pages on studies in Markdown by file name, made from the program's own tables: study-keys.md, alerts.md, figures.md.
[[nodiscard]] std::map<std::string, std::string> study_pages();

}  // namespace setae::cli
