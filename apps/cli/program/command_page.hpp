// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace setae::cli {

/// Pages of Markdown by file name, one per command with its arguments and options, one on the options of files, and
/// their index: docs/reference/commands.
[[nodiscard]] std::map<std::string, std::string> command_pages();

}  // namespace setae::cli
