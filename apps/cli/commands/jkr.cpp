// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr_energy.hpp"
#include "jkr_fit.hpp"
#include "jkr_import.hpp"
#include "verbs.hpp"

namespace setae::cli {

void add_jkr(CLI::App& program, Action& action) {
    auto* group = program.add_subcommand("jkr", "contact experiments with a soft or hard sphere");
    group->require_subcommand(1);
    add_jkr_import(*group, action);
    add_jkr_radius(*group, action);
    add_jkr_fit(*group, action);
    add_jkr_energy(*group, action);
    add_jkr_summary(*group, action);
}

}  // namespace setae::cli
