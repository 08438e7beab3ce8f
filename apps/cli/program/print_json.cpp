// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/print_json.hpp"

#include <nlohmann/json.hpp>

#include "program/messages.hpp"

namespace setae::cli {

void print_json(const output::Json& json) { print(json.dump(2) + "\n"); }

}  // namespace setae::cli
