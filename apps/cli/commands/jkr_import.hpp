// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// `setae jkr import`: a foreign record becomes a loop file, every guess shown.
void add_jkr_import(CLI::App& group, Action& action);

}  // namespace setae::cli
