// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/replicates/mixed_model.hpp"
#include "setae/workflow/json.hpp"
#include "setae/workflow/tidy_table.hpp"

namespace setae::workflow {

/// "quantity", "unit", "levels", "pooling", "surfaces" (mean, prediction interval, heterogeneity, influence …), "variances", "differences",
/// "rows" with the reason of those excluded, "notes". SI.
[[nodiscard]] Json to_json(const replicates::ReplicateData& data, const replicates::MixedModel& model);

/// One row a replicate, excluded ones with their reason.
[[nodiscard]] TidyTable replicate_table(const replicates::ReplicateData& data);
/// One row a surface: mean, interval, prediction interval, heterogeneity, the mean with the excluded rows.
[[nodiscard]] TidyTable replicate_mean_table(const replicates::ReplicateData& data, const replicates::MixedModel& model);

/// Means, variances, differences, influence and exclusions as a terminal shows them.
[[nodiscard]] std::string summary(const replicates::ReplicateData& data, const replicates::MixedModel& model);

}  // namespace setae::workflow
