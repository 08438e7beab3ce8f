// SPDX-License-Identifier: GPL-3.0-or-later
#include "agreement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "setae/core/statistics.hpp"

namespace setae::spectral_fit {
namespace {

/// Σ |ρ|² over the modes of a group with the Hann window: their mean is equivalent to size/this values.
double shared_within(double size) {
    return 1.0 + 2.0 * (4.0 / 9.0 * std::max(0.0, 1.0 - 1.0 / size) + 1.0 / 36.0 * std::max(0.0, 1.0 - 2.0 / size));
}

}  // namespace

std::vector<Agreement> agreement(const std::vector<ObservedGroup>& groups, const WhittleFit& fit) {
    std::map<std::pair<std::string, int>, Agreement> rows;
    std::map<std::pair<std::string, int>, double> weights;
    for (std::size_t c = 0; c < groups.size(); ++c) {
        const auto& g = groups[c];
        for (Index k = 0; k < g.data.wavevector.size(); ++k) {
            const double nu = g.data.freedom[k];
            if (!(nu > 0.0)) continue;
            const std::pair key{g.data.instrument, static_cast<int>(std::floor(std::log10(g.data.wavevector[k])))};
            auto& row = rows[key];
            const double ratio = g.data.periodogram[k] / fit.expected[c][k];
            row.ratio = (weights[key] * (weights[key] > 0.0 ? row.ratio : 0.0) + nu * ratio) / (weights[key] + nu);
            weights[key] += nu;
            const double own = nu / (g.independent_share[k] * shared_within(g.mode_counts[k]));
            row.standard_error += nu * nu / own;
            row.chi_squared += 2.0 * own * (ratio - 1.0 - std::log(ratio)) / (1.0 + 1.0 / (6.0 * own));
            ++row.groups;
        }
    }
    std::vector<Agreement> all;
    for (auto& [key, row] : rows) {
        row.instrument = key.first;
        row.decade = key.second;
        row.standard_error = std::sqrt(row.standard_error) / weights[key];
        row.probability = chi_squared_exceedance(row.chi_squared, row.groups);
        all.push_back(row);
    }
    return all;
}

std::vector<Alert> agreement_alerts(const std::vector<Agreement>& rows) {
    std::vector<Alert> alerts;
    for (const auto& row : rows)
        if (row.probability < improbable_agreement)
            alerts.push_back(
                {"INSTRUMENTS_DISAGREE", row.instrument.empty() ? "instrument not stated" : row.instrument,
                 fmt::format(
                     "between 1e{} and 1e{} 1/m the periodograms of this instrument are {:.2f} times the values of "
                     "the fit, chi² {:.0f} for {} groups of modes",
                     row.decade, row.decade + 1, row.ratio, row.chi_squared, row.groups),
                 "check calibration, tip radius and tip shape of this instrument; compare its own spectrum with "
                 "the others"});
    return alerts;
}

}  // namespace setae::spectral_fit
