// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Writes pages, texts by file name, to a folder, and says how many.
void write_pages(const std::string& folder, const std::map<std::string, std::string>& pages);

}  // namespace setae::cli
