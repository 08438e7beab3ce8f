// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// `setae lab loops`: bias and coverage of every fit of loops, on loops that are known.
void add_lab_loops(CLI::App& group, Action& action);

}  // namespace setae::cli
