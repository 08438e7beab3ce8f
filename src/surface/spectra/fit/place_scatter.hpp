// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "observed_groups.hpp"
#include "setae/core/quantity.hpp"

namespace setae::spectral_fit {

/// Scatter between whole measurements of an instrument.
struct PlaceScatter {
    double variance = 0.0;     ///< τ², of ln of the power at a place
    double probability = 1.0;  ///< probability of deviations as large without scatter
    int measurements = 0;

    /// The τ² from n places as variance of a normal distribution with the 95 % interval of Student's t with n − 1
    /// degrees of freedom.
    [[nodiscard]] double normal_variance() const;
};

/// By instrument, for those with two measurements or more. b_m = Σ ν (P/E − 1)/Σ ν scatters by 1/√Σν about zero, and
/// additionally by τ if the surface varies between places. τ² makes Σ b²/(τ² + 1/Σν) equal to their number minus 1 for
/// the fit (Paule and Mandel), 0 if it is already less.
using Scatter = std::map<std::string, PlaceScatter>;
[[nodiscard]] Scatter scatter_between_places(const std::vector<ObservedGroup>& groups, const WhittleFit& fit);

/// MEASUREMENTS_SCATTER if chance is improbable.
[[nodiscard]] std::vector<Alert> scatter_alerts(const Scatter& scatter);

}  // namespace setae::spectral_fit
