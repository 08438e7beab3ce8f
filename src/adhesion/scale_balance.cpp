// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/scale_balance.hpp"

#include <algorithm>
#include <cmath>

#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::adhesion {

ScaleBalance scale_balance(const roughness::CumulativeParameters& below, double contact_modulus,
                           double work_of_adhesion, double surface_energy) {
    const auto n = below.wavevector.size();
    const double slope2 = std::pow(below.rms_slope[n - 1], 2);
    const double energy = contact_modulus * below.elastic_energy_per_modulus[n - 1];
    const double excess_area = roughness::gaussian_area_ratio(below.rms_slope[n - 1]) - 1.0;
    const auto work = [&](double slope, double stored) {
        return modified_balance(work_of_adhesion, surface_energy, {roughness::gaussian_area_ratio(slope), stored}).raw;
    };
    const double change = work(below.rms_slope[n - 1], energy) - work_of_adhesion;

    ScaleBalance balance{below.wavevector, Array1D(n), Array1D(n), Array1D(n), Array1D(n), Array1D(n), std::nullopt};
    for (Index i = 0; i < n; ++i) {
        const double slope_below = below.rms_slope[i];
        const double stored_below = contact_modulus * below.elastic_energy_per_modulus[i];
        const double slope_above = std::sqrt(std::max(0.0, slope2 - slope_below * slope_below));
        balance.gained[i] = work(slope_above, 0.0);
        balance.stored[i] = energy - stored_below;
        balance.stored_share[i] = stored_below / energy;
        balance.area_share[i] = (roughness::gaussian_area_ratio(slope_below) - 1.0) / excess_area;
        balance.work_share[i] = (work(slope_below, stored_below) - work_of_adhesion) / change;
        if (balance.gained[i] >= balance.stored[i]) continue;
        if (!balance.bridging) balance.bridging = Band{below.wavevector[i], below.wavevector[i]};
        balance.bridging->upper = below.wavevector[i];
    }
    return balance;
}

}  // namespace setae::adhesion
