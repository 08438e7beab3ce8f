// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/pinning_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace setae::hysteresis {
namespace {

struct SimulatedFronts {
    double energy_share;  ///< U_el/(A W)
    PinningCoefficient k;
};
constexpr std::array simulated{SimulatedFronts{0.003, {3.70, 0.4}}, SimulatedFronts{0.01, {3.2, 0.3}},
                               SimulatedFronts{0.03, {2.7, 0.15}}, SimulatedFronts{0.1, {2.02, 0.05}},
                               SimulatedFronts{0.3, {1.54, 0.05}}};

}  // namespace

PinningCoefficient pinning_coefficient(double energy_share) {
    const auto above = std::find_if(simulated.begin(), simulated.end(),
                                    [&](const SimulatedFronts& fronts) { return fronts.energy_share >= energy_share; });
    if (above == simulated.begin()) return above->k;
    if (above == simulated.end()) return simulated.back().k;
    const auto below = above - 1;
    const double way =
        std::log(energy_share / below->energy_share) / std::log(above->energy_share / below->energy_share);
    const auto between = [way](double from, double to) { return from + way * (to - from); };
    return {between(below->k.value, above->k.value), between(below->k.standard_error, above->k.standard_error)};
}

PinningConstants pinning_constants(double energy_share, double larkin_lengths) {
    const auto k = pinning_coefficient(energy_share);
    constexpr double shortest = 10.0;
    return {.approach = k, .retraction = k, .measured = larkin_lengths > shortest};
}

double pinning_uncertainty(double energy_share) {
    const auto k = pinning_coefficient(energy_share);
    return k.standard_error / k.value;
}

double pinning_by_bands(double stored_energy, const std::vector<double>& band_shares, double work) {
    double sum = 0.0;
    for (const double share : band_shares) {
        const double energy = share * stored_energy;
        sum += 2.0 * pinning_coefficient(energy / work).value * energy;
    }
    return sum;
}

}  // namespace setae::hysteresis
