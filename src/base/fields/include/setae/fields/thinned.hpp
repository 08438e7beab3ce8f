// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"

namespace setae::fields {

/// Maximum number of values of a column in outputs; a longer record is thinned to every n-th sample.
inline constexpr Index max_samples = 20'000;

/// Thinning step of a column of this many samples; empty if the output holds all samples.
[[nodiscard]] std::optional<Index> step_of(Index samples);

/// The samples in the output.
[[nodiscard]] Array1D thinned(const Array1D& values);

}  // namespace setae::fields
