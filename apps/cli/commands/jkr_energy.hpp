// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// `setae jkr energy`: where the energy of each loop went, with its error budget.
void add_jkr_energy(CLI::App& group, Action& action);

}  // namespace setae::cli
