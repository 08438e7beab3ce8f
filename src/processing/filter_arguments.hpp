// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/processing/processed.hpp"

namespace setae::processing {

/// @throws InvalidArgument unless the cutoff is positive and finite.
void require_cutoff(double cutoff, std::string_view filter, const topography::Metadata& metadata);

/// The error of a filter that was given a polyline.
[[noreturn]] void refuse_profile(std::string_view step, const topography::Profile& profile);

/// What a filter tells of itself: its cutoff, and where that makes no sense on these points.
[[nodiscard]] StepRecord filter_record(std::string_view step, double cutoff, const topography::Measurement& measurement);

}  // namespace setae::processing
