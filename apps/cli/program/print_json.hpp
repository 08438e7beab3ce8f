// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/output/json.hpp"

namespace setae::cli {

/// Prints data on standard output.
void print_json(const output::Json& json);

}  // namespace setae::cli
