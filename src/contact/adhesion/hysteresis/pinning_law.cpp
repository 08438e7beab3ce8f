// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/pinning_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"
#include "setae/crack_front/pinning.hpp"

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

double min_length(double energy_share) { return 0.965 * (1.0 + 5.3 * std::pow(energy_share, 0.655)); }

constexpr double of_length = 0.68;

double shortness(double energy_share, double larkin_lengths) {
    return std::pow(min_length(energy_share) / larkin_lengths, of_length);
}

/// k∞ exp(−shortness)
double fitted_value(double energy_share, double shortness) {
    return 3.56 / (1.0 + 2.66 * std::pow(energy_share, 0.70)) * std::exp(-shortness);
}

/// k of the fits, and its standard error.
PinningCoefficient fitted(double energy_share, double larkin_lengths) {
    constexpr double other_bands = 0.35, of_fits = 0.04, least = 0.02;
    const double short_of = shortness(energy_share, larkin_lengths), k = fitted_value(energy_share, short_of);
    // dk/d ln N times the effect of other bands on N
    const double of_band = k > 0.0 ? of_length * short_of * other_bands * k : 0.0;
    return {k, std::hypot(of_band, of_fits * k, least)};
}

void require_front(double energy_share, double larkin_lengths) {
    if (!(energy_share >= 0.0 && larkin_lengths >= 0.0))
        throw InvalidArgument(
            fmt::format("pinning with U_el/(AW) = {} on a front of {} Larkin lengths; expected both at least 0",
                        energy_share, larkin_lengths));
}

/// No front was simulated beyond.
double simulated_share(double energy_share) { return std::min(energy_share, longest_fronts.back().energy_share); }

}  // namespace

PinningConstants pinning_constants(double energy_share, double larkin_lengths) {
    require_front(energy_share, larkin_lengths);
    constexpr double beyond_share = 0.3;  // error of k
    const double share = simulated_share(energy_share), longest = longest_front(share),
                 shortest = shortest_front * min_length(share);
    auto k = fitted(share, larkin_lengths);
    const auto widen = [&](double error) { k.standard_error = std::hypot(k.standard_error, error); };
    if (energy_share > share) widen(beyond_share * k.value);
    if (larkin_lengths > longest) widen(k.value - fitted(share, longest).value);
    if (larkin_lengths < shortest) widen(0.5 * k.value);
    const bool measured = energy_share <= share && energy_share >= longest_fronts.front().energy_share &&
                          larkin_lengths >= shortest && larkin_lengths <= longest;
    return {.approach = k, .retraction = k, .measured = measured};
}

double pinning_constant(double energy_share, double larkin_lengths) {
    require_front(energy_share, larkin_lengths);
    const double share = simulated_share(energy_share);
    return fitted_value(share, shortness(share, larkin_lengths));
}

EdgeLengths edge_lengths(double largest_radius, const contact::AdhesiveContact& contact) {
    const double at_pull_off = contact::jkr::pull_off_at_fixed_load(contact).contact_radius;
    return {.approach = crack_front::free_length(largest_radius, contact),
            .retraction = crack_front::free_length(at_pull_off, contact)};
}

double edge_larkin_lengths(double free_length, double mean_wavelength, double energy_share) {
    if (!(energy_share > 0.0)) return 0.0;
    if (std::isinf(free_length)) return free_length;
    return free_length / crack_front::larkin_length(mean_wavelength, energy_share);
}

double pinning_by_bands(double stored_energy, const std::vector<PinningBand>& bands, double work, double free_length) {
    double sum = 0.0;
    for (const auto& band : bands) {
        const double energy = band.share * stored_energy, share = energy / work;
        sum += pinning_constant(share, edge_larkin_lengths(free_length, band.mean_wavelength, share)) * energy;
    }
    return sum;
}

}  // namespace setae::hysteresis
