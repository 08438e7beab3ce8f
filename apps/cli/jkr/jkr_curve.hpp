// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/answers/force_curves.hpp"

namespace setae::cli {

void print_curve(const std::string& file, const loops::ForceCurveAnalysis& analysis);
void print_map(const study::ForceMap& map);

}  // namespace setae::cli
