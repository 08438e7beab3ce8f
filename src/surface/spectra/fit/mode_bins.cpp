// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/mode_bins.hpp"

#include <algorithm>
#include <cmath>

namespace setae::spectral_fit {

ModeBins::ModeBins(Index modes) {
    constexpr Index singles = 16;
    constexpr double growth = 1.0746078283213176;  // 10^(1/32)
    for (Index k = 1; k <= modes;) {
        first_.push_back(k);
        k = k < singles ? k + 1 : std::max(k + 1, static_cast<Index>(std::lround(static_cast<double>(k) * growth)));
    }
    first_.push_back(modes + 1);
}

Array1D ModeBins::means(const ArrayView1D& values) const {
    Array1D result(size());
    for (Index b = 0; b < size(); ++b) result[b] = values.segment(first(b) - 1, count(b)).mean();
    return result;
}

}  // namespace setae::spectral_fit
