// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "loop_arguments.hpp"
#include "setae/experiment/crack_speed_fit.hpp"
#include "setae/experiment/global_fit.hpp"
#include "setae/experiment/profile_likelihood.hpp"

namespace setae::cli {

/// Options of `setae jkr fit` that ask for more than JKR's own routes.
struct ModelArguments {
    std::vector<std::string> models;  ///< names; "all" compares them
    std::string branch = "loading";
    std::string errors = "orthogonal_distance";
    std::string contact_point, cohesive_stress;
    bool profile = false, crack_speed = false;
    std::optional<double> exponent;
    std::vector<std::string> shared;  ///< "modulus", "work"

    void add_to(CLI::App& verb);
    [[nodiscard]] bool wanted() const { return !models.empty() || profile || crack_speed; }
};

/// What was asked for, of one loop.
struct LoopModels {
    std::vector<experiment::ModelFit> fits;
    std::optional<experiment::ModelComparison> comparison;
    std::optional<experiment::ProfileLikelihood> profile;
    std::optional<experiment::CrackSpeedFit> crack_speed;
    std::vector<std::string> failures;  ///< a sentence for each that could not be made
};

[[nodiscard]] LoopModels models_of(const AnalysedLoop& loop, const ModelArguments& arguments);
void print_models(const LoopModels& models);
[[nodiscard]] workflow::Json json_of(const LoopModels& models);

/// Loops gathered for one fit with E* or W shared.
class SharedFit {
public:
    explicit SharedFit(const ModelArguments& arguments) : arguments_(arguments) {}
    [[nodiscard]] bool wanted() const { return !arguments_.shared.empty(); }
    void add(const AnalysedLoop& loop);
    /// @throws InvalidArgument for fewer than two loops; as experiment::fit_globally.
    [[nodiscard]] experiment::GlobalFit fit() const;

private:
    const ModelArguments& arguments_;
    std::vector<experiment::GlobalBranch> branches_;
};

void print_shared(const experiment::GlobalFit& fit);

}  // namespace setae::cli
