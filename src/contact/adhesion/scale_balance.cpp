// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/scale_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::adhesion {
namespace {

void extend(std::optional<Band>& band, double wavevector) {
    if (!band) band = Band{wavevector, wavevector};
    band->upper = wavevector;
}

/// From simulated patches with equal energies and rms height.
double pressure_to_close(double gained, double stored, double rms_height) {
    if (!(stored > 0.0 && rms_height > 0.0)) return 0.0;
    const double share = gained > 0.0 ? stored / gained : std::numeric_limits<double>::infinity();
    return unloaded_contact(share).closing_pressure * stored / rms_height;
}

}  // namespace

const char* name(Closing closing) {
    switch (closing) {
        case Closing::spontaneous: return "spontaneous full contact";
        case Closing::under_pressure: return "full contact only under pressure";
        case Closing::opens: return "opens spontaneously";
    }
    return "";
}

Closing ScaleBalance::closing(Index i) const {
    if (gained[i] < stored[i]) return Closing::opens;
    return closing_pressure[i] > 0.0 ? Closing::under_pressure : Closing::spontaneous;
}

ScaleBalance scale_balance(const roughness::CumulativeParameters& below, double contact_modulus,
                           double work_of_adhesion, double surface_energy, double area_shape) {
    const auto area_ratio = [area_shape](double slope) {
        return 1.0 + area_shape * (roughness::gaussian_area_ratio(slope) - 1.0);
    };
    const auto n = below.wavevector.size();
    const double slope2 = std::pow(below.rms_slope[n - 1], 2);
    const double energy = contact_modulus * below.elastic_energy_per_modulus[n - 1];
    const double excess_area = area_ratio(below.rms_slope[n - 1]) - 1.0;
    const auto work = [&](double slope, double stored) {
        return modified_balance(work_of_adhesion, surface_energy, {area_ratio(slope), stored}).raw;
    };
    const double change = work(below.rms_slope[n - 1], energy) - work_of_adhesion;

    ScaleBalance balance{below.wavevector, Array1D(n), Array1D(n),   Array1D(n),  Array1D(n),
                         Array1D(n),       Array1D(n), std::nullopt, std::nullopt};
    for (Index i = 0; i < n; ++i) {
        const double slope_below = below.rms_slope[i];
        const double stored_below = contact_modulus * below.elastic_energy_per_modulus[i];
        const double slope_above = std::sqrt(std::max(0.0, slope2 - slope_below * slope_below));
        const double height_above =
            std::sqrt(std::max(0.0, std::pow(below.rms_height[n - 1], 2) - below.rms_height[i] * below.rms_height[i]));
        balance.gained[i] = work(slope_above, 0.0);
        balance.stored[i] = energy - stored_below;
        balance.stored_share[i] = stored_below / energy;
        balance.area_share[i] = (area_ratio(slope_below) - 1.0) / excess_area;
        balance.work_share[i] = (work(slope_below, stored_below) - work_of_adhesion) / change;
        balance.closing_pressure[i] = pressure_to_close(balance.gained[i], balance.stored[i], height_above);
        if (balance.closing(i) != Closing::spontaneous) extend(balance.pressed, below.wavevector[i]);
        if (balance.closing(i) == Closing::opens) extend(balance.bridging, below.wavevector[i]);
    }
    return balance;
}

}  // namespace setae::adhesion
