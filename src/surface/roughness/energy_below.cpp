// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/energy_below.hpp"

#include <algorithm>

namespace setae::roughness {

double energy_below(const CumulativeParameters& cumulative, double wavevector) {
    const auto &q = cumulative.wavevector, &energy = cumulative.elastic_energy_per_modulus;
    const auto* above = std::lower_bound(q.data(), q.data() + q.size(), wavevector);
    const Index i = std::clamp<Index>(above - q.data(), 1, q.size() - 1);
    const double way = std::clamp((wavevector - q[i - 1]) / (q[i] - q[i - 1]), 0.0, 1.0);
    return energy[i - 1] + way * (energy[i] - energy[i - 1]);
}

}  // namespace setae::roughness
