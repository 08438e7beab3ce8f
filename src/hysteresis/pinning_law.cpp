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

/// k of the fits, and its standard error.
PinningCoefficient fitted(double energy_share, double larkin_lengths) {
    constexpr double exponent = 0.68, other_bands = 0.35, of_fits = 0.04, least = 0.02;
    const double shortness = std::pow(least_length(energy_share) / larkin_lengths, exponent);
    const double k = 3.56 / (1.0 + 2.66 * std::pow(energy_share, 0.70)) * std::exp(-shortness);
    // dk/d ln N times what other bands do to N
    const double of_band = k > 0.0 ? exponent * shortness * other_bands * k : 0.0;
    return {k, std::hypot(of_band, of_fits * k, least)};
}

}  // namespace

PinningConstants pinning_constants(double energy_share, double larkin_lengths) {
    if (!(energy_share >= 0.0 && larkin_lengths >= 0.0))
        throw InvalidArgument(
            fmt::format("pinning by U_el/(AW) = {} on a front of {} Larkin lengths; expected both at least 0",
                        energy_share, larkin_lengths));
    constexpr double beyond_share = 0.3;  // of k
    const double share = std::min(energy_share, longest_fronts.back().energy_share), longest = longest_front(share),
                 shortest = shortest_front * least_length(share);
    auto k = fitted(share, larkin_lengths);
    const auto widen = [&](double error) { k.standard_error = std::hypot(k.standard_error, error); };
    if (energy_share > share) widen(beyond_share * k.value);
    if (larkin_lengths > longest) widen(k.value - fitted(share, longest).value);
    if (larkin_lengths < shortest) widen(0.5 * k.value);
    const bool measured = energy_share <= share && energy_share >= longest_fronts.front().energy_share &&
                          larkin_lengths >= shortest && larkin_lengths <= longest;
    return {.approach = k, .retraction = k, .measured = measured};
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
