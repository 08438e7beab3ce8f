// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/contact_point.hpp"

namespace setae::loops {

/// fit_with_contact_point, begun at E* and W of a fit nearby, which saves the search for a start.
[[nodiscard]] JkrFit fit_with_contact_point(const BranchData& data, const LensAndCounterBody& bodies,
                                            double contact_point, const JkrFit& near);

}  // namespace setae::loops
