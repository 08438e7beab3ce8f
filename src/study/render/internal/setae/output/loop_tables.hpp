// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/table.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// Bodies of a loop, as far as known; texts of the tidy tables.
struct LoopLabels {
    std::string file, surface, elastomer, lens, spot;
};

/// The labels a loop's metadata state.
[[nodiscard]] LoopLabels labels_stated_in(const Table& loop, const std::string& file);

/// A table of fits without rows: one row for each loop, contact, cycle, branch and method.
[[nodiscard]] tables::TidyTable fits_table();

/// Adds every fit of a loop; a failed one has its reason in the last column.
void add_fits(tables::TidyTable& table, const LoopLabels& labels, const loops::LoopAnalysis& analysis);

/// A table of energies without rows: one row for each contact of a loop, with its energy budget, and one for each
/// cycle.
[[nodiscard]] tables::TidyTable energies_table();
void add_energies(tables::TidyTable& table, const LoopLabels& labels, const loops::LoopAnalysis& analysis);

/// Loops for readers, a row per loop: E*, W of loading, unloading and pull-off, loss, the codes of its warnings.
[[nodiscard]] tables::TidyTable loop_rows_table();
void add_loop_row(tables::TidyTable& table, const std::string& name, const loops::LoopAnalysis& analysis);

}  // namespace setae::output
