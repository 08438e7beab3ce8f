// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/output/json.hpp"
#include "setae/statistics/mixed_model.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// "quantity", "unit", "levels", "pooling", "surfaces" (mean, prediction interval, heterogeneity, influence …),
/// "variances", "differences", "rows" with the reason of those excluded, "notes". SI.
[[nodiscard]] Json to_json(const statistics::ReplicateData& data, const statistics::MixedModel& model);

/// One row a replicate, excluded ones with their reason.
[[nodiscard]] tables::TidyTable replicate_table(const statistics::ReplicateData& data);
/// One row per surface: mean, interval, prediction interval, heterogeneity, the mean with the excluded rows.
[[nodiscard]] tables::TidyTable replicate_mean_table(const statistics::ReplicateData& data,
                                                     const statistics::MixedModel& model);

/// Means, variances, differences, influence and exclusions as a terminal shows them.
[[nodiscard]] std::string summary(const statistics::ReplicateData& data, const statistics::MixedModel& model,
                                  std::size_t width = 100);

}  // namespace setae::output
