// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/study/study_result.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

using Cells = std::vector<tables::TidyTable::Cell>;

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

template <class... T>
void add_cells(Cells& row, T&&... cells) {
    (row.emplace_back(std::forward<T>(cells)), ...);
}

/// Conclusions of a study and, where it uses likelihoods, those with averages.
[[nodiscard]] std::vector<const study::Conclusions*> by_method(const study::StudyResult& result);
/// The method of numbers that depend on all surfaces; surfaces without measurements have no choice.
[[nodiscard]] std::string method_name(const study::StudyResult& result, const study::Conclusions& conclusions);

/// Names of the cells of uncertainty_cells() for a quantity.
[[nodiscard]] std::vector<std::string> uncertainty_columns(const std::string& name, const std::string& unit);
[[nodiscard]] Cells uncertainty_cells(const std::optional<Estimate>& estimate);

}  // namespace setae::output
