// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// Adds `foil` to the verbs of the laboratory.
void add_lab_foil(CLI::App& group, Action& action);

}  // namespace setae::cli
