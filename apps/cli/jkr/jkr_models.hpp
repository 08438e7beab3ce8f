// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/answers/loops.hpp"

namespace setae::cli {

/// Prints the model fits of a loop, below the name of the loop if it is not empty.
void print_models(const std::string& loop, const study::LoopModels& models);
void print_shared(const loops::GlobalFit& fit);

}  // namespace setae::cli
