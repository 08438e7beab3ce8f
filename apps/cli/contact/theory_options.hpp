// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/options.hpp"
#include "setae/answers/persson_contact.hpp"

namespace setae::cli {

/// What Persson's theory takes of the body and the load; `pressures`: more that is said of --pressure.
void add_theory_options(Options& options, answers::PerssonRequest& request, const char* pressures = "");

}  // namespace setae::cli
