// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/pinning_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

/// The longest fronts that were simulated.
struct LongestFronts {
    double energy_share;    ///< U_el/(A W)
    double larkin_lengths;  ///< N
};
constexpr std::array longest_fronts{LongestFronts{0.001, 0.62}, LongestFronts{0.003, 3.7}, LongestFronts{0.01, 12.4},
                                    LongestFronts{0.03, 18.5},  LongestFronts{0.1, 62.0},  LongestFronts{0.3, 46.0}};
constexpr double shortest_front = 0.4;  ///< of N0

double longest_front(double energy_share) {
    const auto above = std::ranges::upper_bound(longest_fronts, energy_share, {}, &LongestFronts::energy_share);
    if (above == longest_fronts.begin()) return longest_fronts.front().larkin_lengths;
    if (above == longest_fronts.end()) return longest_fronts.back().larkin_lengths;
    const auto below = above - 1;
    const double way =
        std::log(energy_share / below->energy_share) / std::log(above->energy_share / below->energy_share);
    return below->larkin_lengths * std::pow(above->larkin_lengths / below->larkin_lengths, way);
}

double least_length(double energy_share) { return 0.965 * (1.0 + 5.3 * std::pow(energy_share, 0.655)); }

double fitted(double energy_share, double larkin_lengths) {
    return 3.56 / (1.0 + 2.66 * std::pow(energy_share, 0.70)) *
           std::exp(-std::pow(least_length(energy_share) / larkin_lengths, 0.68));
}

}  // namespace

PinningConstants pinning_constants(double energy_share, double larkin_lengths) {
    if (!(energy_share >= 0.0 && larkin_lengths >= 0.0))
        throw InvalidArgument(
            fmt::format("pinning by U_el/(AW) = {} on a front of {} Larkin lengths; expected both at least 0",
                        energy_share, larkin_lengths));
    constexpr double between_bands = 0.08, of_fits = 0.02, beyond_share = 0.3;
    const double share = std::min(energy_share, longest_fronts.back().energy_share), longest = longest_front(share),
                 shortest = shortest_front * least_length(share);
    const double k = fitted(share, larkin_lengths);
    double outside = 0.0;
    if (energy_share > share) outside = beyond_share * k;
    if (larkin_lengths > longest) outside = std::hypot(outside, k - fitted(share, longest));
    if (larkin_lengths < shortest) outside = std::hypot(outside, 0.5 * k);
    const bool measured = energy_share <= share && energy_share >= longest_fronts.front().energy_share &&
                          larkin_lengths >= shortest && larkin_lengths <= longest;
    const PinningCoefficient either{k, std::hypot(between_bands * k, of_fits, outside)};
    return {.approach = either, .retraction = either, .measured = measured};
}

PinningConstants pinning_constants(const std::vector<PinningBand>& bands) {
    double all = 0.0;
    for (const auto& band : bands) all += band.energy_share;
    if (!(all > 0.0)) throw InvalidArgument("pinning by bands that store nothing; expected U_b/(AW) above 0 of one");
    PinningConstants sum;
    const auto add = [](PinningCoefficient& to, const PinningCoefficient& of, double weight) {
        to.value += weight * of.value;
        to.standard_error += weight * of.standard_error;
    };
    for (const auto& band : bands) {
        const auto of_band = pinning_constants(band.energy_share, band.larkin_lengths);
        add(sum.approach, of_band.approach, band.energy_share / all);
        add(sum.retraction, of_band.retraction, band.energy_share / all);
        sum.measured = sum.measured && of_band.measured;
    }
    return sum;
}

PinningCoefficient pinning_coefficient(double energy_share) {
    return pinning_constants(energy_share, std::numeric_limits<double>::infinity()).retraction;
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
