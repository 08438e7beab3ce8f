// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "setae/processing/processed.hpp"

namespace setae::processing {

/// @throws InvalidArgument unless the cutoff is positive and finite.
void require_cutoff(double cutoff, std::string_view filter, const topography::Metadata& metadata);

/// Throws the error of a filter for a polyline.
[[noreturn]] void refuse_profile(std::string_view step, const topography::Profile& profile);

/// Record of a filter: its cutoff, and a warning if the cutoff is unsuitable for these points.
[[nodiscard]] StepRecord filter_record(std::string_view step, double cutoff,
                                       const topography::Measurement& measurement);

/// A filter as a step of a pipeline. `in_place` filters a map or a line scan in place and returns the number of
/// iterations of weights, which the record contains for weighted filters.
template <class Filter, class InPlace>
Processed filtered_in_place(const Filter& filter, topography::Measurement measurement, InPlace in_place,
                            bool weighted) {
    if (const auto* profile = std::get_if<topography::Profile>(&measurement))
        refuse_profile(step_name(filter), *profile);
    StepRecord record = filter_record(step_name(filter), filter.cutoff, measurement);
    auto* map = std::get_if<topography::HeightMap>(&measurement);
    const int weightings = map ? in_place(*map) : in_place(std::get<topography::LineScan>(measurement));
    if (weighted)
        record.numbers.push_back({.quantity = "weightings",
                                  .symbol = "n",
                                  .estimate = {.value = static_cast<double>(weightings), .standard_error = 0.0},
                                  .unit = "1"});
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
