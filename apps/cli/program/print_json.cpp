// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/print_json.hpp"

#include <nlohmann/json.hpp>

#include "program/messages.hpp"

namespace setae::cli {

void print_json(const output::Json& json) { print(output::as_text(json)); }

}  // namespace setae::cli
