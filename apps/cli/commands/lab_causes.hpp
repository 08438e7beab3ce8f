// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// Adds `causes` to the verbs of the laboratory.
void add_causes(CLI::App& group, Action& action);

}  // namespace setae::cli
