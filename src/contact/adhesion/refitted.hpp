// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// The fit of the pairs changed by change(pair), with fixed scatter.
template <class Change>
GeneralisedFit refitted(const std::vector<PairPoint>& pairs, const ModelScatter& scatter, const Change& change) {
    std::vector<PairPoint> changed;
    std::transform(pairs.begin(), pairs.end(), std::back_inserter(changed), change);
    return fit_generalised(changed, scatter);
}

}  // namespace setae::adhesion
