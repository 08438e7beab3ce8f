// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/statistics/replicate_data.hpp"

namespace setae::statistics {

/// A variance that can be distinguished from the others: between the groups of a level.
struct DesignLevel {
    std::vector<std::string> includes;  ///< names of the levels whose groups these are, outermost first
    std::vector<int> group;             ///< group of each row of the design, increasing unless crossed
    int groups = 0;
    int degrees_of_freedom = 0;
    bool crossed = false;  ///< whether its groups extend over several surfaces
};

/// Rows in the order of their groups, so that every nested group's rows are neighbours, with the levels whose variances
/// can be estimated, crossed ones first. The last level, if any, is nested and has one row per group.
struct NestedDesign {
    std::vector<std::string> surfaces;
    std::vector<std::size_t> rows;  ///< rows of the data
    std::vector<int> surface;       ///< surface of each row of the design, increasing
    Array1D value;
    Array1D known_variance;  ///< 0 where no standard error is known
    std::vector<DesignLevel> levels;
    std::vector<std::string> not_estimable;

    [[nodiscard]] Index size() const { return value.size(); }
    [[nodiscard]] bool crossed() const { return !levels.empty() && levels.front().crossed; }
};

/// The design of some rows of valid data; surfaces in the order of their first row.
[[nodiscard]] NestedDesign nested_design(const ReplicateData& data, const std::vector<std::size_t>& rows);

/// Whether a level's labels are common to all surfaces.
[[nodiscard]] bool is_crossed(const ReplicateData& data, const std::string& level);

/// Whether no row has a label at a level.
[[nodiscard]] bool level_missing(const ReplicateData& data, std::size_t level);

}  // namespace setae::statistics
