// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Writes a page of the documentation. @throws FileError for an existing file with another first line.
void write_page(const std::string& path, const std::string& page);

/// Writes pages, texts by file name, to a folder, and prints their number.
void write_pages(const std::string& folder, const std::map<std::string, std::string>& pages);

}  // namespace setae::cli
