// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/output/json.hpp"
#include "setae/statistics/mixed_model.hpp"
#include "setae/study/replicate_reader.hpp"

namespace setae::answers {

/// What `setae jkr summary` is asked: tables with a row a fit, and how rows become replicates.
struct ReplicateRequest {
    std::vector<std::string> files;
    study::ReplicateColumns columns;   ///< but for its groups
    std::string group_by, crossed;     ///< "surface,lens"
    std::vector<std::string> exclude;  ///< "file=a.csv;reason=dust on the lens"
    std::string exclusions;            ///< a file of them
    bool each_surface = false;         ///< variances of each surface by itself, not pooled
};

/// Replicates and what they say together.
struct ReplicateSummary {
    study::ReplicateTables tables;
    statistics::MixedModel model;
};

/// @throws as study::read_replicates(), the readers of exclusions and statistics::mixed_model().
[[nodiscard]] ReplicateSummary replicate_summary(const ReplicateRequest& request);

/// As output::to_json() of replicates, and "bad_rows".
[[nodiscard]] output::Json to_json(const ReplicateSummary& summary);

}  // namespace setae::answers
