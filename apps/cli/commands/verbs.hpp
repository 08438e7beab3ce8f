// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// Each adds its verb to the program and sets `action` when the verb was named.
void add_info(CLI::App& program, Action& action);
void add_formats(CLI::App& program, Action& action);
void add_container(CLI::App& program, Action& action);
void add_convert(CLI::App& program, Action& action);
void add_level(CLI::App& program, Action& action);
void add_contour(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_profile(CLI::App& program, Action& action);
void add_tip(CLI::App& program, Action& action);
void add_psd(CLI::App& program, Action& action);
void add_sdrp(CLI::App& program, Action& action);
void add_acf(CLI::App& program, Action& action);
void add_vbw(CLI::App& program, Action& action);
void add_params(CLI::App& program, Action& action);
void add_adhesion(CLI::App& program, Action& action);
void add_jkr(CLI::App& program, Action& action);
void add_jkr_radius(CLI::App& jkr_group, Action& action);
void add_jkr_summary(CLI::App& jkr_group, Action& action);
void add_synthesize(CLI::App& program, Action& action);
void add_lab(CLI::App& program, Action& action);
void add_study(CLI::App& program, Action& action);
void add_plot(CLI::App& program, Action& action);
void add_cache(CLI::App& program, Action& action);
void add_completion(CLI::App& program, Action& action);
void add_man(CLI::App& program, Action& action);

}  // namespace setae::cli
