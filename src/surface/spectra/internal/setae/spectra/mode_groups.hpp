// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// Modes of an instrument that are treated separately; long profiles have many more.
inline constexpr Index modes_by_themselves = 2048;

/// Groups of neighbouring modes that are treated as one, so the cost does not grow with the number of modes.
///
/// The first `by_themselves` modes are groups of one. Each later group reaches from its first wavevector q to q ·
/// ratio. wavevector: increasing, > 0.  ratio: > 1.  The result contains the first mode of each group, then the number
/// of modes.
[[nodiscard]] std::vector<Index> narrow_groups(const ArrayView1D& wavevector, double ratio,
                                               Index by_themselves = modes_by_themselves);

}  // namespace setae::spectra
