// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jkr/loop_arguments.hpp"
#include "program/options.hpp"

namespace setae::cli {

/// Options of `setae jkr fit` that ask for more than JKR's own routes.
struct ModelArguments : answers::LoopModelsRequest {
    void add_to(Options& options);
};

/// The models of a loop, below its name where that is not empty.
void print_models(const std::string& loop, const study::LoopModels& models);
void print_shared(const loops::GlobalFit& fit);

}  // namespace setae::cli
