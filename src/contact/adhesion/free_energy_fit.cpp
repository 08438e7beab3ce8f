// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/free_energy_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "floored_least_squares.hpp"
#include "pair_least_squares.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::adhesion {

PairPoint FreeEnergyPoint::storing(double energy_per_modulus) const {
    auto point = pair;
    point.offset += contact_modulus.value * energy_per_modulus;
    point.offset_inputs = combined({{1.0, pair.offset_inputs}, {energy_per_modulus, contact_modulus.components}});
    return point;
}

FreeEnergyFit fit_with_free_energies(const std::vector<FreeEnergyPoint>& pairs) {
    if (pairs.size() < 2)
        throw InvalidArgument(fmt::format("{} pairs; a fit over pairs needs at least 2", pairs.size()));
    std::map<std::string, std::vector<FreeEnergyPoint>> by_surface;
    std::vector<double> measured;
    double largest = 0.0;
    for (const auto& point : pairs) {
        by_surface[point.pair.surface].push_back(point);
        measured.push_back(point.pair.measured.value);
        largest = std::max(largest, measured.back());
    }
    // with x = −u the prediction is max(0, E* x − (offset − slope W))
    const auto best_energy = [](const std::vector<FreeEnergyPoint>& points, double work) {
        std::vector<FlooredTerm> terms;
        for (const auto& p : points)
            terms.push_back({p.pair.measured.value, p.contact_modulus.value, -p.pair.raw_prediction(work)});
        return floored_minimum(terms, -std::numeric_limits<double>::infinity(), 0.0);
    };
    const auto cost = [&](double work) {
        double sum = 0.0;
        for (const auto& [name, points] : by_surface) sum += best_energy(points, work).cost;
        return sum;
    };
    // the cost has kinks, so the deepest valley is looked for on a grid before it is refined
    constexpr int grid = 400;
    const double step = 2.0 * largest / grid;
    double best = 0.0;
    for (int i = 0; i <= grid; ++i)
        if (cost(i * step) < cost(best)) best = i * step;
    const auto minimum = numerics::minimum_between(cost, std::max(0.0, best - step), best + step, 40);
    FreeEnergyFit fit{minimum.place, 1.0 - minimum.value / squares_about_mean(measured), {}, {}};
    for (const auto& [name, points] : by_surface)
        fit.energy_per_modulus.emplace_back(name, -best_energy(points, minimum.place).x);
    return fit;
}

}  // namespace setae::adhesion
