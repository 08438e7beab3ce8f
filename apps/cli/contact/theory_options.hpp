// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/options.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/persson_contact.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::cli {

/// What Persson's theory takes of the body and the load; `pressures`: more that is said of --pressure.
void add_theory_options(Options& options, answers::PerssonRequest& request, const char* pressures = "");

/// The surface of the files, as far as its spectrum goes.
[[nodiscard]] study::SurfaceResult surface_for_theory(const SurfaceOptions& surface, parallel::Threads threads);

}  // namespace setae::cli
