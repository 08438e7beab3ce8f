// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "setae/study/hysteresis.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// "87.9 ± 4.4 mJ/m²": the parameter of a model that has one, as fitted.
[[nodiscard]] std::string fitted_number(const hysteresis::ModelScore& score);

/// Best model of W_ret, its errors, models that cannot be excluded and the pair that distinguishes them.
[[nodiscard]] std::vector<std::string> hysteresis_sentences(const study::Hysteresis& hysteresis);
/// These sentences in lines of at most so many characters.
[[nodiscard]] std::string hysteresis_answer(const study::Hysteresis& hysteresis, std::size_t width);

/// Answer and tables for a terminal.
[[nodiscard]] std::string hysteresis_text(const study::Hysteresis& hysteresis, std::size_t width);

/// One row per ranking and model, SI.
[[nodiscard]] tables::TidyTable model_table(const study::Hysteresis& hysteresis);
/// One row per true model of the trials.
[[nodiscard]] tables::TidyTable trial_table(const study::Hysteresis& hysteresis);
/// One row per pair: W_ret, pull-off and loss predicted and measured, SI.
[[nodiscard]] tables::TidyTable hysteresis_table(const study::Hysteresis& hysteresis);
/// One row per pair and model: W_ret from roughness only, SI.
[[nodiscard]] tables::TidyTable model_work_table(const study::Hysteresis& hysteresis);
/// One row per measured pair: the energy budget of its loop, SI.
[[nodiscard]] tables::TidyTable decomposition_table(const study::Hysteresis& hysteresis);

/// All tables that have rows, with the names of their files.
[[nodiscard]] std::vector<std::pair<std::string, tables::TidyTable>> hysteresis_tables(
    const study::Hysteresis& hysteresis);

}  // namespace setae::output
