// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/study/force_map.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// One row per curve: number, position, pixel, E*, E, W, pull-off force and energy loss with their standard errors in
/// SI, and the reasons of missing values.
[[nodiscard]] tables::TidyTable curves_table(const study::ForceMap& map);

/// One row a quantity, in the units of the field: of how many curves, quantiles.
[[nodiscard]] tables::TidyTable spread_table(const study::ForceMap& map);

/// Writes NAME.csv, curves_table(), and where the file states a grid NAME.gwy, each quantity as a map; makes the
/// folder.
/// @throws FileError.
/// @return the files written.
std::vector<std::string> write_force_map(const study::ForceMap& map, const std::string& folder,
                                         const std::string& name);

}  // namespace setae::output
