// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// All verbs with their arguments and options as a page of Markdown: docs/reference/verbs.md.
[[nodiscard]] std::string verb_page();

}  // namespace setae::cli
