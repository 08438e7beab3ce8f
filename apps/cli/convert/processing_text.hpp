// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/processing/steps.hpp"

namespace setae::cli {

/// Name and numbers of a step on one line.
[[nodiscard]] std::string as_line(const processing::StepRecord& record);

/// All steps with their parameters, for --explain.
[[nodiscard]] std::string step_list();

/// All steps with their parameters as a page of Markdown: docs/reference/processing-steps.md.
[[nodiscard]] std::string step_page();

}  // namespace setae::cli
