// SPDX-License-Identifier: GPL-3.0-or-later
#include "container.hpp"

#include "verbs.hpp"

namespace setae::cli {

void add_container(CLI::App& program, Action& action) {
    auto* group =
        program.add_subcommand("container", "containers of contact.engineering: what is in them, and making them");
    group->require_subcommand(1);
    add_container_check(*group, action);
    add_container_write(*group, action);
}

}  // namespace setae::cli
