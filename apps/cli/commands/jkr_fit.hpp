// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// `setae jkr fit`: E*, W and their uncertainties by every route.
void add_jkr_fit(CLI::App& group, Action& action);

}  // namespace setae::cli
