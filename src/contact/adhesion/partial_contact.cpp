// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/partial_contact.hpp"

#include <math.h>  // pchip.hpp looks for isnan where C puts it

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/interpolators/pchip.hpp>
#include <boost/math/special_functions/fpclassify.hpp>

#include "balance_score.hpp"
#include "pair_least_squares.hpp"
#include "setae/adhesion/traced_function.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/words.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::adhesion {
namespace {

/// Results of docs/validation/conformity.md for patches at ρ/h_rms = 0.05.
struct SimulatedPatches {
    double energy_share, area_fraction, area_error, gain, gain_error, closing_pressure;
};
constexpr std::array simulated{SimulatedPatches{0, 1, 0, 1, 0, 0},
                               SimulatedPatches{0.05, 1, 0, 0.95, 0, 0},
                               SimulatedPatches{0.1, 1, 0, 0.9, 0, 0},
                               SimulatedPatches{0.15, 1, 0, 0.85, 0, 0},
                               SimulatedPatches{0.2, 0.997, 0.001, 0.8, 0.0001, 0},
                               SimulatedPatches{0.25, 0.99, 0.002, 0.75, 0.0013, 0},
                               SimulatedPatches{0.3, 0.982, 0.0055, 0.7, 0.001, 0.18},
                               SimulatedPatches{0.4, 0.941, 0.0045, 0.6033, 0.0058, 0.77},
                               SimulatedPatches{0.5, 0.893, 0.019, 0.5116, 0.0075, 1.09},
                               SimulatedPatches{0.6, 0.818, 0.019, 0.4323, 0.0153, 1.46},
                               SimulatedPatches{0.7, 0.761, 0.0115, 0.3568, 0.0133, 1.71},
                               SimulatedPatches{0.85, 0.663, 0.012, 0.2751, 0.0231, 2.07},
                               SimulatedPatches{1, 0.56, 0.0255, 0.1985, 0.0171, 2.35},
                               SimulatedPatches{1.2, 0.458, 0.023, 0.1339, 0.0181, 2.63},
                               SimulatedPatches{1.5, 0.3, 0.0105, 0.0726, 0.0242, 2.92},
                               SimulatedPatches{2, 0.12, 0.0305, 0.0201, 0.0175, 3.29},
                               SimulatedPatches{3, 0.031, 0.0035, 0.0049, 0.0052, 3.75}};
constexpr double last_share = simulated.back().energy_share;
constexpr double power_beyond = -3.0;  ///< exponent of gain and area beyond the last
/// Divided by U_el/(A h_rms): contact on 99 % of a Gaussian surface without attraction, erf(√2 p/(h'E*)) of it, in a
/// band of 16.
constexpr double closing_without_adhesion = 6.8;

/// A column of the table as a curve.
class Curve {
public:
    explicit Curve(double SimulatedPatches::*column) : curve_(shares(), values(column)) {}
    [[nodiscard]] double operator()(double energy_share) const { return curve_(energy_share); }

private:
    static std::vector<double> shares() { return values(&SimulatedPatches::energy_share); }
    static std::vector<double> values(double SimulatedPatches::*column) {
        std::vector<double> found;
        for (const auto& patches : simulated) found.push_back(patches.*column);
        return found;
    }
    boost::math::interpolators::pchip<std::vector<double>> curve_;
};

UnloadedContact beyond_the_table(double energy_share) {
    const auto& last = simulated.back();
    const double fall = std::pow(energy_share / last_share, power_beyond), near = last_share / energy_share;
    return {.area_fraction = last.area_fraction * fall,
            .area_error = last.area_error * fall,
            .gain = last.gain * fall,
            .gain_error = last.gain_error * fall,
            .closing_pressure = closing_without_adhesion + near * (last.closing_pressure - closing_without_adhesion)};
}

double squares(const std::vector<PartialContactPoint>& pairs, double work) {
    double sum = 0.0;
    for (const auto& pair : pairs) sum += std::pow(pair.gained.measured.value - pair.prediction(work), 2);
    return sum;
}

/// The deepest valley over W_int: a grid first, then by Brent.
std::pair<double, double> best_work(const std::vector<PartialContactPoint>& pairs) {
    double most = 0.0;
    for (const auto& pair : pairs)
        most =
            std::max(most, (pair.gained.measured.value + pair.stored_energy + pair.gained.offset) / pair.gained.slope);
    constexpr int grid = 400, bits = 40;
    const double step = 2.0 * most / grid;
    int best = 1;
    for (int i = 2; i <= grid; ++i)
        if (squares(pairs, i * step) < squares(pairs, best * step)) best = i;
    const auto minimum = numerics::minimum_between([&](double work) { return squares(pairs, work); }, (best - 1) * step,
                                                   (best + 1) * step, bits);
    return {minimum.place, minimum.value};
}

double left_out_deviation(const std::vector<PartialContactPoint>& pairs) {
    std::map<std::string, std::vector<PartialContactPoint>> surfaces;
    for (const auto& pair : pairs) surfaces[pair.gained.surface].push_back(pair);
    if (surfaces.size() < 2) return undefined;
    double sum = 0.0;
    for (const auto& [name, own] : surfaces) {
        std::vector<PartialContactPoint> others;
        std::ranges::copy_if(pairs, std::back_inserter(others),
                             [&](const PartialContactPoint& pair) { return pair.gained.surface != name; });
        sum += squares(own, best_work(others).first);
    }
    return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace

UnloadedContact unloaded_contact(double energy_share) {
    static const Curve area(&SimulatedPatches::area_fraction), span(&SimulatedPatches::area_error),
        gain(&SimulatedPatches::gain), error(&SimulatedPatches::gain_error),
        pressure(&SimulatedPatches::closing_pressure);
    const double e = std::max(0.0, energy_share);
    if (e >= last_share) return beyond_the_table(e);
    // between nodes a cubic may pass below the chord: full contact is there for any body to choose
    return {.area_fraction = area(e),
            .area_error = span(e),
            .gain = std::max(gain(e), 1.0 - e),
            .gain_error = error(e),
            .closing_pressure = e > closing_energy_share ? pressure(e) : 0.0};
}

double partial_balance(double gain, double stored_energy, double patches) {
    if (!(gain > 0.0)) return 0.0;
    const auto contact = unloaded_contact(stored_energy / gain);
    return gain * (contact.gain + patches * contact.gain_error);
}

double PartialContactPoint::prediction(double work) const {
    return partial_balance(gained.raw_prediction(work), stored_energy);
}

BalanceScore score_partial_contact(const std::vector<PartialContactPoint>& pairs) {
    if (pairs.size() < 2)
        throw InvalidArgument(
            fmt::format("{}; a comparison of balances needs at least 2", counted(pairs.size(), "pair", "pairs")));
    std::vector<double> values;
    for (const auto& pair : pairs) values.push_back(pair.gained.measured.value);
    const auto [work, residual] = best_work(pairs);
    auto score = score_of(1, work, residual, squares_about_mean(values), pairs.size());
    score.left_out_deviation = left_out_deviation(pairs);
    return score;
}

TracedValue partial_prediction(const RoughSide& rough, const SoftSide& soft, const TracedValue& work) {
    const TracedValue table({.value = 0.0, .standard_error = 1.0}, simulated_patches_input);
    return traced_function(rough, {work, soft.surface_energy, soft.contact_modulus, table},
                           [](const roughness::SpectralParameters& p, const std::vector<double>& in) {
                               const double r = p.area_ratio();
                               return partial_balance(in[0] * r - in[1] * (r - 1.0),
                                                      in[2] * p.elastic_energy_per_modulus, in[3]);
                           });
}

}  // namespace setae::adhesion
