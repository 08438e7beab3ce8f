// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

void add_container_check(CLI::App& group, Action& action);
void add_container_write(CLI::App& group, Action& action);

}  // namespace setae::cli
