// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "program/command.hpp"
#include "setae/fields/option.hpp"
#include "setae/validation/summary.hpp"

namespace setae::cli {

/// Options of commands that make the data set of a recipe several times.
struct RepeatedRecipe {
    Common common;
    std::string recipe;
    std::string output;  ///< folder of tables and figure
    int runs = 1;
    std::uint64_t seed = 1;
};

/// Registers recipe, --output, --runs and --seed; their present values are the defaults.
void add_options(Options& options, RepeatedRecipe& repeated);

/// @throws InvalidArgument without a recipe.
void require_recipe(const RepeatedRecipe& repeated);

/// "n of N runs" on standard error if it is a terminal, else nothing.
[[nodiscard]] std::function<void(int)> progress_of(int runs);

/// NAME.txt, NAME.csv and the figure as NAME.svg, .png and .pdf in a folder.
/// @throws FileError.
void write_closure(const std::vector<validation::SummaryRow>& rows, const std::string& name, const std::string& folder);

}  // namespace setae::cli

template <>
struct setae::fields::Asked<setae::cli::RepeatedRecipe> {
    using R = cli::RepeatedRecipe;
    static constexpr std::array options{
        option<&R::runs>("runs", "number of data sets").default_shown(),
        option<&R::seed>("seed", "seed of the first data set; further data sets use the next numbers").default_shown(),
    };
};
