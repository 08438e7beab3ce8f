// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// All commands with their arguments and options as a page of Markdown: docs/reference/commands.md.
[[nodiscard]] std::string command_page();

}  // namespace setae::cli
