// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "force_minimum.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// As setae::median, of a copy.
[[nodiscard]] double median_of(Array1D values);

/// When each sample was: its time where all are known and none runs backwards, else its number.
[[nodiscard]] Array1D clock_of(const Loop& loop);

/// σ_F and how many samples count as one, from free flight.
[[nodiscard]] SampleNoise sample_noise(const Baseline& baseline);

/// A baseline in the free flight given by the user. @throws InvalidArgument for fewer than five samples, and as
/// samples_of.
[[nodiscard]] Baseline given_baseline(const Loop& loop, const GivenRange& range, const std::string& name);

/// Zero of force, its slope and noise from a section of free flight.
[[nodiscard]] Baseline baseline_over(const Loop& loop, const IndexRange& range);

}  // namespace setae::loops
