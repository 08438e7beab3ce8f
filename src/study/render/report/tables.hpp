// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/study/study_result.hpp"
#include "table.hpp"

namespace setae::report {

/// The tables of a study; those without rows are left out. `study` is output::to_json(result): every number is an entry
/// of it.
[[nodiscard]] std::vector<DataTable> parameter_tables(const study::StudyResult& result, const output::Json& study);

/// Every measurement: its processing and results, or the reason of its failure.
[[nodiscard]] DataTable measurement_table(const study::StudyResult& result);

/// Every loop, or why it failed.
[[nodiscard]] DataTable loop_table(const study::StudyResult& result);

/// Name of a balance or fit of the JSON for users: "modified" is "(7)".
[[nodiscard]] std::string balance_name(const std::string& fit);

}  // namespace setae::report
