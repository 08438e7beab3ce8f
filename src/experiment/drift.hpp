// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/experiment/segments.hpp"

namespace setae::experiment {

/// Where each sample lies between the middles of two baselines: 0 at the first, 1 at the second, by time where it is known.
[[nodiscard]] Array1D share_of_drift(const Loop& loop, const IndexRange& before, const IndexRange& after);

/// The loop with its zero of force where the first baseline has it throughout: the linear drift to the second one, where
/// both are known, taken off.
[[nodiscard]] Loop without_force_drift(const Loop& loop, const Segments& segments);

}  // namespace setae::experiment
