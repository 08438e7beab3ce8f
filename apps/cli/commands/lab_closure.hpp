// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// Adds `closure` to the verbs of the laboratory.
void add_closure(CLI::App& group, Action& action);

}  // namespace setae::cli
