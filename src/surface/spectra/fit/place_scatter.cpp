// SPDX-License-Identifier: GPL-3.0-or-later
#include "place_scatter.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/statistics.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::spectral_fit {
namespace {

struct Departure {
    double square, own_variance;
};

double chi_squared(const std::vector<Departure>& all, double variance) {
    double sum = 0.0;
    for (const auto& d : all) sum += d.square / (variance + d.own_variance);
    return sum;
}

PlaceScatter scatter_of(const std::vector<Departure>& all) {
    const auto count = static_cast<double>(all.size());
    PlaceScatter found{.probability = chi_squared_exceedance(chi_squared(all, 0.0), count),
                       .measurements = static_cast<int>(all.size())};
    const double expected = count - 1.0;
    if (chi_squared(all, 0.0) <= expected) return found;
    double most = 0.0;
    for (const auto& d : all) most += d.square / expected;  // makes χ² smaller than that
    const auto [lower, upper] =
        numerics::bisected([&](double v) { return chi_squared(all, v) > expected; }, 0.0, most, 60);
    found.variance = 0.5 * (lower + upper);
    return found;
}

}  // namespace

double PlaceScatter::normal_variance() const {
    if (!(variance > 0.0)) return 0.0;
    const double wider = student_t_quantile(0.975, measurements - 1.0) / normal_quantile(0.975);
    return wider * wider * variance;
}

Scatter scatter_between_places(const std::vector<ObservedGroup>& groups, const WhittleFit& fit) {
    std::map<std::string, std::vector<Departure>> departures;
    for (std::size_t c = 0; c < groups.size(); ++c) {
        const auto& g = groups[c];
        const double freedom = g.data.freedom.sum() / g.measurements;
        if (!(freedom > 0.0)) continue;
        for (const auto& periodogram : g.periodograms) {
            const double departure =
                (g.data.freedom * (periodogram / fit.expected[c] - 1.0)).sum() / g.data.freedom.sum();
            departures[g.data.instrument].push_back({departure * departure, 1.0 / freedom});
        }
    }
    Scatter scatter;
    for (const auto& [instrument, all] : departures)
        if (all.size() > 1) scatter[instrument] = scatter_of(all);
    return scatter;
}

std::vector<Alert> scatter_alerts(const Scatter& scatter) {
    constexpr double significant = 0.01;
    std::vector<Alert> alerts;
    for (const auto& [instrument, found] : scatter)
        if (found.probability < significant)
            alerts.push_back(
                {"MEASUREMENTS_SCATTER", instrument.empty() ? "instrument not stated" : instrument,
                 fmt::format(
                     "the measurements of this instrument differ from each other by {:.0f} % in power more than "
                     "their waves explain; the intervals include this scatter",
                     100.0 * std::sqrt(found.variance)),
                 "measure more places: the surface differs from place to place, or its heights are not Gaussian"});
    return alerts;
}

}  // namespace setae::spectral_fit
