// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/segments.hpp"

namespace setae::loops {

/// The sample before the largest change of force within a jump.
[[nodiscard]] Index largest_step(const Array1D& force, const IndexRange& jump);

}  // namespace setae::loops
