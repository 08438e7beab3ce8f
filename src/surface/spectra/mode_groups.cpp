// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/mode_groups.hpp"

namespace setae::spectra {

std::vector<Index> narrow_groups(const ArrayView1D& wavevector, double ratio, Index by_themselves) {
    std::vector<Index> first;
    for (Index k = 0; k < wavevector.size(); ++k)
        if (k < by_themselves || k == 0 || wavevector[k] > ratio * wavevector[first.back()]) first.push_back(k);
    first.push_back(wavevector.size());
    return first;
}

}  // namespace setae::spectra
