// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/experiment/segments.hpp"

namespace setae::experiment {

[[nodiscard]] double median(Array1D values);

/// σ of independent noise [unit of the series] on a smooth course: √⟨(x_{i−1} − 2x_i + x_{i+1})²/6⟩; 0 for fewer than
/// three samples.
[[nodiscard]] double white_noise(const ArrayView1D& series);

/// Zero of force and noise from a stretch of free flight.
[[nodiscard]] Baseline baseline_over(const Loop& loop, const IndexRange& range);

}  // namespace setae::experiment
