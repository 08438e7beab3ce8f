// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jkr/loop_arguments.hpp"
#include "program/options.hpp"
#include "setae/study/loop_models.hpp"

namespace setae::cli {

/// Options of `setae jkr fit` that ask for more than JKR's own routes.
struct ModelArguments {
    std::vector<std::string> models, shared;
    std::string branch = "loading", errors = "orthogonal_distance";
    std::string contact_point, cohesive_stress;
    bool profile = false, crack_speed = false;
    std::optional<double> exponent;

    void add_to(Options& options);
    /// @throws InvalidArgument for a malformed quantity.
    [[nodiscard]] study::LoopModelOptions options() const;
};

void print_models(const study::LoopModels& models);
void print_shared(const loops::GlobalFit& fit);

}  // namespace setae::cli
